#include "openr/live/live_server.h"

#include <fmt/format.h>
#include <poll.h>
#include <sys/socket.h>
#include <sys/un.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>

#include "cli/json_text.h"
#include "openr/live/couplings.h"
#include "openr/live/live_folder.h"
#include "openr/live/request_reader.h"
#include "runtime/base/assert.h"
#include "runtime/base/wall_clock.h"

namespace openr_host {
namespace {

constexpr int64_t kNsPerMs = 1'000'000;
constexpr int64_t kIntervalNs = 2 * kNsPerMs;
constexpr int64_t kLastAnswersNs = 3'000 * kNsPerMs;
constexpr int kPeriodMs = 8;  // shortest time between two events of a kind: one frame
constexpr int kPeriodMaxMs = 1000;

nlohmann::json ParseRequest(const std::string& line) {
  try {
    return ParseJson<nlohmann::json>(line);
  } catch (const nlohmann::json::exception& error) {
    // Leaves out the beginning of the text, such as "[json.exception.parse_error.101] ", because it
    // names a class of the JSON library.
    const std::string why = error.what();
    throw std::runtime_error("the request is no JSON: " + why.substr(why.find(' ') + 1));
  }
}

// Returns the index in LiveEvents::Kinds() of the event that the element `wanted` of a request
// names.
size_t KindOfEvent(const JsonReader& wanted) {
  const std::string name = wanted.Text();
  const std::vector<LiveEvents::Kind>& kinds = LiveEvents::Kinds();
  std::string known;
  for (size_t i = 0; i < kinds.size(); ++i) {
    if (name == kinds[i].name) return i;
    known += (known.empty() ? "" : ", ") + std::string(kinds[i].name);
  }
  wanted.Fail("there is no event '{}'; known are {}", name, known);
}

}  // namespace

LiveServer::LiveServer(const std::string& name, Answer answer, LiveEvents* events,
                       Couplings* couplings)
    : name_(name), answer_(std::move(answer)), events_(events), couplings_(couplings) {
  LiveRuns();  // removes the sockets of runs that were killed
  Open();
}

void LiveServer::Open() {
  const std::string path = LiveSocketPath(name_);
  sockaddr_un address{};
  address.sun_family = AF_UNIX;
  const auto fail = [&](const std::string& why) {
    if (listener_ >= 0) close(std::exchange(listener_, -1));
    throw std::runtime_error(fmt::format("{}: cannot listen: {}", path, why));
  };
  if (path.size() >= sizeof address.sun_path) fail("the path is too long for a socket");
  std::memcpy(address.sun_path, path.c_str(), path.size() + 1);
  listener_ = socket(AF_UNIX, SOCK_STREAM | SOCK_NONBLOCK | SOCK_CLOEXEC, 0);
  if (listener_ < 0) fail(std::strerror(errno));
  const auto is_bound = [&] {
    return bind(listener_, reinterpret_cast<const sockaddr*>(&address), sizeof address) == 0;
  };
  if (!is_bound()) {
    if (errno != EADDRINUSE) fail(std::strerror(errno));
    // Removes a socket that an earlier process with the same id has left.  Keeps an open socket,
    // because it belongs to a run in another container: process ids there may be the same as here.
    if (IsLiveSocketOpen(path))
      fail("another run has this socket open; give this run another name with --run-name");
    unlink(path.c_str());
    if (!is_bound()) fail(std::strerror(errno));
  }
  if (listen(listener_, kClientsMax) != 0) {
    const int error = errno;
    unlink(path.c_str());
    fail(std::strerror(error));
  }
  path_ = path;
  process_ = getpid();
}

void LiveServer::Forget() {
  for (const Client& client : clients_) close(client.descriptor);
  clients_.clear();
  if (couplings_ != nullptr) couplings_->Forget();
  if (listener_ >= 0) close(std::exchange(listener_, -1));
}

void LiveServer::OpenAgain() {
  ASSERT(listener_ < 0 && clients_.empty());
  Open();
}

// Sends the answers that are queued for clients, because a run at full speed may end before its
// clients have taken all answers.  Gives up after kLastAnswersNs, because a client may never read.
void LiveServer::SendLastAnswers() {
  const int64_t end_ns = WallClockNs() + kLastAnswersNs;
  for (;;) {
    std::vector<pollfd> waited;
    for (Client& client : clients_) {
      if (!Send(&client)) client.to_send.clear();
      if (!client.to_send.empty()) waited.push_back({client.descriptor, POLLOUT, 0});
    }
    const int64_t left_ms = (end_ns - WallClockNs()) / kNsPerMs;
    if (waited.empty() || left_ms <= 0) return;
    poll(waited.data(), waited.size(), static_cast<int>(left_ms));
  }
}

LiveServer::~LiveServer() {
  // Sends the last answers, and below removes the file of the socket, only in the process that made
  // the socket.  A fork must not do so, because the clients and the file belong to the original
  // process.
  if (getpid() == process_) SendLastAnswers();
  Forget();
  if (getpid() == process_) unlink(path_.c_str());
}

void LiveServer::Accept() {
  for (;;) {
    const int descriptor = accept4(listener_, nullptr, nullptr, SOCK_NONBLOCK | SOCK_CLOEXEC);
    if (descriptor < 0) return;
    if (clients_.size() == kClientsMax) {
      close(descriptor);
    } else {
      clients_.push_back({++client_count_, descriptor, "", "", {}, {}});
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
    nlohmann::json request;
    try {
      request = ParseRequest(line);
      CheckFractions(request, Fractions::kBounded);
      answer = AnswerTo(client, request);
    } catch (const JsonTooDeep& error) {
      answer = {{"error", error.what()}};
      // Looks for the request's id in the text of the line, because JSON that is nested too deeply
      // is not read, and the client may wait for the answer with this id.
      const nlohmann::json id = PlainMember(line, "id");
      if (!id.is_null()) request["id"] = id;
    } catch (const std::exception& error) {
      answer = {{"error", error.what()}};
    }
    if (request.is_object() && request.contains("id")) answer["id"] = request["id"];
    client->to_send += JsonText(answer) + "\n";
    if (client->to_send.size() > kAnswersMax) return false;
  }
  return client->received.size() <= kRequestMax;
}

// Returns the answer to a request.  Answers "watch" and "couple" itself, because the function
// answer_ does not know which client has sent the request.  For all other requests calls answer_,
// which answers from the state of the run.
nlohmann::ordered_json LiveServer::AnswerTo(Client* client, const nlohmann::json& request) {
  const std::string what = RequestReader(request).At("do").Text();
  if (what == "watch") return BeginWatch(client, request);
  if (what == "couple" && couplings_ != nullptr) {
    ASSERT(events_ != nullptr);
    RobotOfRequest(request, events_->robot_count());  // throws if the run has no such robot
    return couplings_->Answer(client->number, request);
  }
  return answer_(request);
}

// Answers the request "watch".  From now on `client` gets only the events that the request names.
nlohmann::ordered_json LiveServer::BeginWatch(Client* client, const nlohmann::json& request) {
  if (events_ == nullptr) throw std::runtime_error("there is nothing to watch here");
  const JsonReader reader = RequestReader(request);
  const int64_t period_ms = reader.WholeOr("period_ms", kPeriodMs, kPeriodMaxMs, kPeriodMs);
  std::vector<Watch> watches;
  for (const JsonReader& wanted : reader.At("events").Elements()) {
    const size_t kind = KindOfEvent(wanted);
    watches.push_back(
        {kind, std::max(LiveEvents::Kinds()[kind].interval_ns, period_ms * kNsPerMs), 0});
  }
  client->watches = std::move(watches);
  client->cursor = {};
  UpdateGraphWatch();
  return {{"watching", !client->watches.empty()}};
}

// Tells `events_` whether any client watches the event "graph".  The history of messages, which
// this event shows, is kept only while a client watches this event.
void LiveServer::UpdateGraphWatch() {
  if (events_ == nullptr) return;
  const auto is_graph = [](const Watch& watch) {
    return std::string_view(LiveEvents::Kinds()[watch.kind].name) == "graph";
  };
  events_->WatchGraph(std::any_of(clients_.begin(), clients_.end(), [&](const Client& client) {
    return std::any_of(client.watches.begin(), client.watches.end(), is_graph);
  }));
}

bool LiveServer::is_watched() const {
  return std::any_of(clients_.begin(), clients_.end(),
                     [](const Client& client) { return !client.watches.empty(); });
}

// Adds to the bytes for `client` all events (lines about the state of the run) whose time has come.
// Adds none while the client has not taken earlier bytes, so that a slow client gets fewer events
// instead of old ones.
void LiveServer::SendEvents(Client* client, int64_t now_ns) {
  if (!client->to_send.empty()) return;
  for (Watch& watch : client->watches) {
    if (now_ns < watch.next_ns) continue;
    // Counts the interval from the time when this event was due, and not from now.  The run serves
    // its clients only between frames of 8 ms.  An interval of 16 ms that is counted from now may
    // end just after the run has served its clients, and the event would come after 24 ms.
    watch.next_ns = std::max(watch.next_ns + watch.interval_ns, now_ns);
    const std::string line = events_->Line(LiveEvents::Kinds()[watch.kind].name, &client->cursor);
    if (!line.empty()) client->to_send += line + "\n";
  }
}

// Reads and answers all requests that `client` has sent; does not wait for more.  Returns false if
// the client must be closed, because it has closed its side, has exceeded a limit or cannot be
// reached.
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

void LiveServer::ServeAll() {
  const int64_t now_ns = WallClockNs();
  next_ns_ = now_ns + kIntervalNs;
  Accept();
  const size_t count = clients_.size();
  std::erase_if(clients_, [this, now_ns](Client& client) {
    // Sends the answers even if the client has closed its side, because a client may close its side
    // as soon as it has sent its last request.
    const bool goes_on = Receive(&client);
    SendEvents(&client, now_ns);
    const bool is_sent = Send(&client);
    if (goes_on && is_sent) return false;
    close(client.descriptor);
    if (couplings_ != nullptr) couplings_->End(client.number);
    return true;
  });
  if (clients_.size() != count) UpdateGraphWatch();
}

void LiveServer::Serve() {
  if (WallClockNs() >= next_ns_) ServeAll();
}

void LiveServer::WaitAndServe(int timeout_ms) {
  std::vector<pollfd> waited = {{listener_, POLLIN, 0}};
  for (const Client& client : clients_) {
    const int events = client.to_send.empty() ? POLLIN : POLLIN | POLLOUT;
    waited.push_back({client.descriptor, static_cast<short>(events), 0});
  }
  poll(waited.data(), waited.size(), timeout_ms);
  ServeAll();
}

}  // namespace openr_host
