#include "openr/live/live_server.h"

#include <fmt/format.h>
#include <sys/socket.h>
#include <sys/un.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <utility>

#include "cli/json_text.h"
#include "openr/live/live_folder.h"
#include "runtime/base/wall_clock.h"

namespace openr_host {
namespace {

constexpr int64_t kIntervalNs = 2'000'000;

}  // namespace

LiveServer::LiveServer(const std::string& name, Answer answer)
    : answer_(std::move(answer)), path_(LiveSocketPath(name)), process_(getpid()) {
  sockaddr_un address{};
  address.sun_family = AF_UNIX;
  const auto fail = [this](const std::string& why) {
    if (listener_ >= 0) close(listener_);
    throw std::runtime_error(fmt::format("{}: cannot listen: {}", path_, why));
  };
  if (path_.size() >= sizeof address.sun_path) fail("the path is too long for a socket");
  std::memcpy(address.sun_path, path_.c_str(), path_.size() + 1);
  unlink(path_.c_str());  // an earlier process with the same id may have left it behind
  listener_ = socket(AF_UNIX, SOCK_STREAM | SOCK_NONBLOCK | SOCK_CLOEXEC, 0);
  if (listener_ < 0 ||
      bind(listener_, reinterpret_cast<const sockaddr*>(&address), sizeof address) != 0 ||
      listen(listener_, kClientsMax) != 0)
    fail(std::strerror(errno));
}

LiveServer::~LiveServer() {
  for (const Client& client : clients_) close(client.descriptor);
  close(listener_);
  if (getpid() == process_) unlink(path_.c_str());
}

void LiveServer::Accept() {
  for (;;) {
    const int descriptor = accept4(listener_, nullptr, nullptr, SOCK_NONBLOCK | SOCK_CLOEXEC);
    if (descriptor < 0) return;
    if (clients_.size() == kClientsMax) {
      close(descriptor);
    } else {
      clients_.push_back({descriptor, "", ""});
    }
  }
}

// Answers the complete lines that `client` has sent.  Returns false if the client must be closed,
// because its request is longer than kRequestMax, or more than kAnswersMax bytes of answers wait.
bool LiveServer::AnswerLines(Client* client) {
  for (size_t end = client->received.find('\n'); end != std::string::npos;
       end = client->received.find('\n')) {
    const std::string line = client->received.substr(0, end);
    client->received.erase(0, end + 1);
    nlohmann::ordered_json answer;
    try {
      answer = answer_(nlohmann::json::parse(line));
    } catch (const std::exception& error) {
      answer = {{"error", error.what()}};
    }
    client->to_send += JsonText(answer) + "\n";
    if (client->to_send.size() > kAnswersMax) return false;
  }
  return client->received.size() <= kRequestMax;
}

// Reads and answers what `client` has sent, without waiting for more.  Returns false if the client
// must be closed, because it has sent its last request, is beyond a limit or cannot be reached.
bool LiveServer::Receive(Client* client) {
  char buffer[16 << 10];
  for (;;) {
    const ssize_t count = recv(client->descriptor, buffer, sizeof buffer, 0);
    if (count < 0) return errno == EAGAIN || errno == EINTR;
    if (count == 0) return false;
    client->received.append(buffer, static_cast<size_t>(count));
    if (!AnswerLines(client)) return false;
  }
}

bool LiveServer::Send(Client* client) {
  while (!client->to_send.empty()) {
    const ssize_t count =
        send(client->descriptor, client->to_send.data(), client->to_send.size(), MSG_NOSIGNAL);
    if (count < 0) return errno == EAGAIN || errno == EINTR;
    client->to_send.erase(0, static_cast<size_t>(count));
  }
  return true;
}

void LiveServer::Serve() {
  const int64_t now_ns = WallClockNs();
  if (now_ns < next_ns_) return;
  next_ns_ = now_ns + kIntervalNs;
  Accept();
  std::erase_if(clients_, [this](Client& client) {
    // A client may send its last request and close its side at once, so it gets its answers even if
    // the connection is over.
    const bool goes_on = Receive(&client);
    const bool is_sent = Send(&client);
    if (goes_on && is_sent) return false;
    close(client.descriptor);
    return true;
  });
}

}  // namespace openr_host
