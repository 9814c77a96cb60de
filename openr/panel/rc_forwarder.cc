#include "openr/panel/rc_forwarder.h"

#include <netinet/in.h>
#include <netinet/tcp.h>
#include <poll.h>
#include <sys/socket.h>
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <cerrno>
#include <chrono>
#include <exception>
#include <optional>
#include <system_error>
#include <thread>
#include <utility>

#include "RemoteFiles.h"
#include "RemotePacket.h"
#include "RemoteProtocol.h"
#include "openr/panel/access.h"
#include "openr/remote/tcp_stream.h"
#include "runtime/base/wall_clock.h"

namespace openr_host {

struct RcForwarder::Rules {
  RcCalls::FindAddress find_address;
  std::string token;
  bool allows_controllers;
};

namespace {

// The longest time for which the server reads and drops what a client still sends before it closes
// the client's connection, so that the client can read the last answer.
constexpr int64_t kEndTimeoutMs = 500;
constexpr std::chrono::milliseconds kConnectTimeout{1000};

constexpr size_t kReceiveMax = 2 * RC_MAX_PACKET;  // number of bytes that fit into an RcFramer

std::atomic<int> g_clients = 0, g_without_token = 0;

// Waits until poll() reports one of `events` for `socket`.  Returns false if this does not happen
// before `deadline_ms`, a time of the wall clock.
bool WaitFor(int socket, short events, int64_t deadline_ms) {
  const int64_t left_ms = std::max<int64_t>(deadline_ms - WallClockMs(), 0);
  pollfd wanted = {socket, events, 0};
  return poll(&wanted, 1, static_cast<int>(left_ms)) > 0;
}

// Sends all of `bytes`.  Returns false if the connection was lost, or if it has not taken all bytes
// within kSendTimeoutMs.
bool SendAll(int socket, const uint8_t* bytes, size_t size) {
  const int64_t deadline_ms = WallClockMs() + RcForwarder::kSendTimeoutMs;
  for (size_t sent = 0; sent < size;) {
    const ssize_t n = send(socket, bytes + sent, size - sent, MSG_NOSIGNAL | MSG_DONTWAIT);
    if (n > 0) {
      sent += static_cast<size_t>(n);
    } else if (errno == EAGAIN) {
      if (!WaitFor(socket, POLLOUT, deadline_ms)) return false;
    } else if (errno != EINTR) {
      return false;
    }
  }
  return true;
}

enum class Received { kBytes, kEnd, kLost };

// Receives bytes from `socket` and gives them to `framer`, which finds packets in them.
Received Receive(int socket, RcFramer* framer) {
  uint8_t bytes[kReceiveMax];
  const ssize_t n = recv(socket, bytes, static_cast<size_t>(framer->Room()), MSG_DONTWAIT);
  if (n > 0) framer->Append(bytes, static_cast<int>(n));
  if (n == 0) return Received::kEnd;
  return n > 0 || errno == EAGAIN || errno == EINTR ? Received::kBytes : Received::kLost;
}

// An answer to a client of the remote control that the RcForwarder makes in place of the robot.
struct OwnAnswer {
  RcHeader request;
  int status;
  std::string error;
  bool ends_connection;
};

// Forwards the packets of one client of the remote control to the robot, and the robot's answers to
// the client.
class Forwarding {
 public:
  Forwarding(int client, const RcForwarder::Rules& rules) : client_(client), rules_(rules) {}

  // Reads the first packet of the client of the remote control.  Returns whether it has the token,
  // a secret; if not, tells the client that it is refused.
  bool ReceiveToken();
  // Connects to the robot, and forwards packets until one side ends its connection.
  void Forward();
  // Tells the client of the remote control that it is refused, and ends the connection.
  void Refuse(int status, const std::string& why);

 private:
  void Answer(const OwnAnswer& answer);
  void EndStream() const;
  bool ForwardRequests();
  bool ReceiveRequests();
  bool ReceiveAnswers();
  std::optional<OwnAnswer> OwnAnswerToRequest() const;

  const int client_;
  const RcForwarder::Rules& rules_;
  int robot_ = -1;
  RcFramer requests_, answers_;
  // Header of the first packet that the client of the remote control has sent.
  RcHeader first_ = {RC_HEADER_SIZE, RC_VERSION_FILES, 0, 0};
  bool is_client_sending_ = true;  // false: the client sends no more, but still reads answers
  int unanswered_ = 0;             // number of requests that the robot has not answered yet
  // An answer that waits until the robot has answered all earlier requests, because answers come in
  // the order of the requests.  No request is read meanwhile.
  std::optional<OwnAnswer> delayed_;
};

void Forwarding::Answer(const OwnAnswer& answer) {
  uint8_t packet[RC_MAX_PACKET];
  RcWriter writer(packet, sizeof packet);
  for (int i = 0; i < RC_HEADER_SIZE; ++i) writer.U8(0);
  writer.U32(0xffffffff);  // field for the frame number; 0xffffffff: none
  writer.U16(static_cast<Uint32>(answer.status));
  writer.U16(0);
  if (answer.status != rcOK) writer.String(answer.error);
  writer.PutHeader(answer.request.command, answer.request.tag, answer.request.version);
  SendAll(client_, packet, static_cast<size_t>(writer.Size()));
}

// Ends the stream to the client, and drops what the client still sends.  If the socket were closed
// with unread bytes, the client could not read the answer.
void Forwarding::EndStream() const {
  shutdown(client_, SHUT_WR);
  const int64_t deadline_ms = WallClockMs() + kEndTimeoutMs;
  uint8_t bytes[4096];
  while (WallClockMs() < deadline_ms && WaitFor(client_, POLLIN, deadline_ms)) {
    if (recv(client_, bytes, sizeof bytes, MSG_DONTWAIT) <= 0) return;
  }
}

void Forwarding::Refuse(int status, const std::string& why) {
  Answer({first_, status, why, true});
  EndStream();
}

bool Forwarding::ReceiveToken() {
  const int64_t deadline_ms = WallClockMs() + RcForwarder::kTokenTimeoutMs;
  RcFramer::Result result = requests_.Next();
  while (result == RcFramer::NEEDS_MORE) {
    if (!WaitFor(client_, POLLIN, deadline_ms) || Receive(client_, &requests_) != Received::kBytes)
      return false;
    result = requests_.Next();
  }
  if (result == RcFramer::PACKET) {
    first_ = requests_.Header();
    RcReader reader(requests_.Payload(), requests_.PayloadSize());
    const std::string token = reader.String();
    if (first_.command == rcTOKEN && reader.IsComplete() && IsSameSecret(token, rules_.token))
      return true;
  }
  Refuse(rcerrorNOT_ALLOWED, first_.command == rcTOKEN
                                 ? "the token is wrong"
                                 : "a token is needed here: copy the file that openr run got by "
                                   "--token-file, and say openr rc "
                                   "HOST --token-file FILE");
  return false;
}

// Returns the answer of the forwarder itself to the client's last request; nullopt if this request
// may go to the robot.
std::optional<OwnAnswer> Forwarding::OwnAnswerToRequest() const {
  const RcHeader& header = requests_.Header();
  // Refuses a request with the command 0, and does not send it to the robot.  A request can have
  // the command 0 and the tag 0, and the robot's answer would have both, too.  ReceiveAnswers()
  // does not count such a packet as an answer, so the request would count as unanswered for ever.
  if (header.command == 0)
    return OwnAnswer{header, rcerrorUNKNOWN_COMMAND, "there is no command 0", false};
  // Treats the upload of every kind of file except a motion as code, so that a kind that the
  // protocol gets later is not allowed by mistake.
  const bool is_code = header.command == rcUPLOAD_BEGIN && requests_.PayloadSize() > 0 &&
                       requests_.Payload()[0] != rcfileMOTION;
  if (!is_code || rules_.allows_controllers) return std::nullopt;
  return OwnAnswer{header, rcerrorNOT_ALLOWED,
                   "a controller is code, so it cannot be uploaded from another computer; openr "
                   "run --listen takes it with --allow-uploads",
                   false};
}

// Receives the requests that have come from the client of the remote control.  Sends them to the
// robot, or answers them here if they must not reach the robot.  Returns false if the connection
// must end.
bool Forwarding::ForwardRequests() {
  for (;;) {
    if (delayed_) {
      if (unanswered_ > 0) return true;
      Answer(*delayed_);
      if (delayed_->ends_connection) return false;
      delayed_.reset();
    }
    const RcFramer::Result result = requests_.Next();
    if (result == RcFramer::NEEDS_MORE) return true;
    if (result == RcFramer::BROKEN) {
      delayed_ =
          OwnAnswer{{RC_HEADER_SIZE, RC_VERSION, 0, 0}, rcerrorBAD_PACKET, requests_.Error(), true};
    } else if (delayed_ = OwnAnswerToRequest(); !delayed_) {
      // Does not count the command EVENT, by which a client acknowledges events, because it has no
      // answer.
      if (requests_.Header().command != rcEVENT) ++unanswered_;
      if (!SendAll(robot_, requests_.Payload() - RC_HEADER_SIZE, requests_.Header().size))
        return false;
    }
  }
}

bool Forwarding::ReceiveRequests() {
  switch (Receive(client_, &requests_)) {
    case Received::kBytes:
      return ForwardRequests();
    case Received::kEnd:
      is_client_sending_ = false;
      shutdown(robot_, SHUT_WR);  // the robot answers all requests, and then closes the connection
      return true;
    case Received::kLost:
      return false;
  }
  return false;
}

bool Forwarding::ReceiveAnswers() {
  if (Receive(robot_, &answers_) != Received::kBytes) return false;
  RcFramer::Result result = answers_.Next();
  for (; result == RcFramer::PACKET; result = answers_.Next()) {
    const RcHeader& header = answers_.Header();
    // An event does not answer a request, and neither does the packet by which the robot refuses a
    // ninth client.  So they do not lower the number of unanswered requests.
    const bool is_answer = header.command != rcEVENT && (header.command != 0 || header.tag != 0);
    if (is_answer && unanswered_ > 0) --unanswered_;
    if (!SendAll(client_, answers_.Payload() - RC_HEADER_SIZE, header.size)) return false;
  }
  return result == RcFramer::NEEDS_MORE && ForwardRequests();
}

void Forwarding::Forward() {
  std::optional<remote::TcpStream> robot;
  try {
    robot.emplace(rules_.find_address(), kConnectTimeout);
  } catch (const std::exception& error) {
    return Refuse(rcerrorBUSY, error.what());
  }
  robot_ = robot->descriptor();
  Answer({first_, rcOK, "", false});
  if (!ForwardRequests()) return EndStream();
  for (;;) {
    const bool is_reading = is_client_sending_ && !delayed_;
    // Passes the client's socket to poll() even while nothing is read from it (no POLLIN), because
    // poll() still tells when the client has closed its connection.
    pollfd both[2] = {{client_, static_cast<short>(is_reading ? POLLIN : 0), 0},
                      {robot_, POLLIN, 0}};
    if (poll(both, 2, -1) < 0 && errno != EINTR) return;
    if (!is_reading && both[0].revents != 0) return;
    const bool goes_on =
        (both[1].revents == 0 || ReceiveAnswers()) && (both[0].revents == 0 || ReceiveRequests());
    if (!goes_on) return EndStream();
  }
}

void Serve(int client, const RcForwarder::Rules& rules) {
  const int on = 1;
  setsockopt(client, IPPROTO_TCP, TCP_NODELAY, &on, sizeof on);
  // Makes the kernel test connections on which nothing is sent (keep-alive), so that clients whose
  // computers are gone are found.
  setsockopt(client, SOL_SOCKET, SO_KEEPALIVE, &on, sizeof on);
  Forwarding forwarding(client, rules);
  const bool knows_token = forwarding.ReceiveToken();
  // Counts the client in g_clients before g_without_token is decreased, because HasThreads() must
  // not find both numbers 0 while this thread runs.
  const int clients = knows_token ? ++g_clients : 0;
  --g_without_token;
  if (!knows_token) return;
  if (clients <= RcForwarder::kClientsMax) {
    forwarding.Forward();
  } else {
    forwarding.Refuse(rcerrorBUSY, "too many clients are connected");
  }
  --g_clients;
}

}  // namespace

RcForwarder::RcForwarder(RcCalls::FindAddress find_address, std::string token,
                         bool allows_controllers)
    : rules_(std::make_shared<const Rules>(
          Rules{std::move(find_address), std::move(token), allows_controllers})) {}

void RcForwarder::ServeClient(int connection) {
  if (++g_without_token > kWithoutTokenMax) {
    --g_without_token;
    close(connection);
    return;
  }
  try {
    std::thread([connection, rules = rules_] {
      Serve(connection, *rules);
      close(connection);
    }).detach();
  } catch (const std::system_error&) {
    // Closes the connection, because this computer cannot make a thread for the new client.  The
    // client was counted in g_without_token above.
    --g_without_token;
    close(connection);
  }
}

bool RcForwarder::HasThreads() { return g_clients > 0 || g_without_token > 0; }

}  // namespace openr_host
