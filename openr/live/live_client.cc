#include "openr/live/live_client.h"

#include <fmt/format.h>
#include <poll.h>
#include <sys/socket.h>
#include <sys/time.h>
#include <sys/un.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <nlohmann/json.hpp>
#include <stdexcept>

#include "cli/json_text.h"

namespace openr_host {
LiveClient::LiveClient(const LiveRun& run, int timeout_ms)
    : name_(fmt::format("run {} (process {})", run.name, run.process)), timeout_ms_(timeout_ms) {
  sockaddr_un address{};
  address.sun_family = AF_UNIX;
  std::memcpy(address.sun_path, run.socket.c_str(),
              std::min(run.socket.size(), sizeof address.sun_path - 1));
  descriptor_ = socket(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0);
  // Sets time limits. connect() waits while many other clients wait for the run, and send() waits
  // while the run reads nothing.  If the process of the run is stopped (SIGSTOP), both would wait
  // for ever.
  const timeval limit = {timeout_ms / 1000, timeout_ms % 1000 * 1000};
  setsockopt(descriptor_, SOL_SOCKET, SO_SNDTIMEO, &limit, sizeof limit);
  if (descriptor_ < 0 ||
      connect(descriptor_, reinterpret_cast<const sockaddr*>(&address), sizeof address) != 0) {
    const int error = errno;
    if (descriptor_ >= 0) close(descriptor_);
    throw std::runtime_error(fmt::format("{}: {}", name_, std::strerror(error)));
  }
}

LiveClient::~LiveClient() { close(descriptor_); }

nlohmann::ordered_json LiveClient::Ask(const nlohmann::ordered_json& request) {
  const std::string line = JsonText(request) + "\n";
  for (size_t sent = 0; sent < line.size();) {
    const ssize_t count = send(descriptor_, line.data() + sent, line.size() - sent, MSG_NOSIGNAL);
    if (count <= 0) throw std::runtime_error(name_ + " has ended");
    sent += static_cast<size_t>(count);
  }
  size_t end = 0;
  while ((end = received_.find('\n')) == std::string::npos) {
    pollfd wanted = {descriptor_, POLLIN, 0};
    if (poll(&wanted, 1, timeout_ms_) == 0)
      throw std::runtime_error(name_ + " does not answer; is it stopped?");
    char buffer[16 << 10];
    const ssize_t count = recv(descriptor_, buffer, sizeof buffer, 0);
    if (count <= 0) throw std::runtime_error(name_ + " has ended");
    received_.append(buffer, static_cast<size_t>(count));
  }
  const std::string answer = received_.substr(0, end);
  received_.erase(0, end + 1);
  return ParseJson<nlohmann::ordered_json>(answer);
}

}  // namespace openr_host
