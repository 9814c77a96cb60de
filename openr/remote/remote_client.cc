#include "openr/remote/remote_client.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <netdb.h>
#include <netinet/tcp.h>
#include <poll.h>
#include <sys/socket.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <charconv>
#include <cstring>

namespace openr_host {
namespace {

std::vector<uint8_t> MakePacket(int version, int command, uint16_t tag,
                                const std::vector<uint8_t>& payload) {
  std::vector<uint8_t> packet(RC_HEADER_SIZE + payload.size());
  RcWriter writer(packet.data(), static_cast<int>(packet.size()));
  for (int i = 0; i < RC_HEADER_SIZE; ++i) writer.U8(0);
  writer.Bytes(payload.data(), static_cast<int>(payload.size()));
  writer.PutHeader(command, tag, version);
  return packet;
}

// Returns the text of an answer with an error.
std::string ErrorText(const std::vector<uint8_t>& payload) {
  return RcReader(payload.data(), static_cast<int>(payload.size())).String();
}

}  // namespace

std::string ParseRemoteAddress(const std::string& text, RemoteAddress* address) {
  const size_t colon = text.rfind(':');
  if (colon != text.find(':')) {
    return fmt::format(
        "'{}' has more than one colon; the network of a robot is IPv4, so there are no IPv6 "
        "addresses: write 127.0.0.1:54000",
        text);
  }
  address->host = text.substr(0, colon);
  if (address->host.empty()) return fmt::format("'{}' names no host; write 127.0.0.1:54000", text);
  if (colon == std::string::npos) return "";
  const char* const end = text.data() + text.size();
  const auto [stop, error] = std::from_chars(text.data() + colon + 1, end, address->port);
  if (error == std::errc() && stop == end && address->port != 0) return "";
  return fmt::format("'{}' has no port from 1 to 65535 after the colon", text);
}

RemoteClient::RemoteClient(const RemoteAddress& address, int timeout_ms, bool is_probe)
    : address_(address), timeout_ms_(timeout_ms), is_probe_(is_probe) {
  try {
    Connect();
  } catch (...) {
    if (socket_ >= 0) close(socket_);
    throw;
  }
}

RemoteClient::~RemoteClient() {
  if (socket_ >= 0) close(socket_);
}

bool RemoteClient::WaitFor(short events) const {
  pollfd wanted{socket_, events, 0};
  int ready = 0;
  do {
    ready = poll(&wanted, 1, timeout_ms_);
  } while (ready < 0 && errno == EINTR);
  return ready > 0;
}

void RemoteClient::Connect() {
  addrinfo hints{};
  hints.ai_family = AF_INET;
  hints.ai_socktype = SOCK_STREAM;
  addrinfo* found = nullptr;
  const int problem =
      getaddrinfo(address_.host.c_str(), std::to_string(address_.port).c_str(), &hints, &found);
  if (problem != 0) {
    Throw(fmt::format("no address of '{}' is known ({}); this machine is 127.0.0.1", address_.host,
                      gai_strerror(problem)));
  }
  // The socket does not block, because connect() must give up after timeout_ms_.
  socket_ = socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC | SOCK_NONBLOCK, 0);
  const int result = connect(socket_, found->ai_addr, found->ai_addrlen);
  int error = result == 0 ? 0 : errno;
  freeaddrinfo(found);
  if (error == EINPROGRESS) error = WaitForConnection();
  if (error == ECONNREFUSED) {
    Throw(
        "no program listens there; is 'openr run' running, and is this the port it printed? If it "
        "has ended, its last line says why");
  }
  if (error == ETIMEDOUT) {
    Throw(fmt::format("no connection within {} ms; {}", timeout_ms_,
                      "the address is not that of the robot, or too many clients wait for it"));
  }
  if (error != 0) {
    Throw(fmt::format("cannot be reached: {}; are host and port those of the robot?",
                      std::strerror(error)));
  }
  // Nagle's algorithm holds small packets back.  It is switched off, because requests are small and
  // must leave at once.
  const int on = 1;
  setsockopt(socket_, IPPROTO_TCP, TCP_NODELAY, &on, sizeof on);
}

int RemoteClient::WaitForConnection() const {
  if (!WaitFor(POLLOUT)) return ETIMEDOUT;
  int error = 0;
  socklen_t size = sizeof error;
  getsockopt(socket_, SOL_SOCKET, SO_ERROR, &error, &size);
  return error;
}

void RemoteClient::Throw(const std::string& why) const {
  throw RemoteFailure(fmt::format("{}: {}", address_.Text(), why));
}

void RemoteClient::ThrowSilent() const {
  Throw(
      fmt::format("connected, but no answer within {} ms; the robot is still booting, or serves as "
                  "many clients as it can (8): wait (--timeout), or end another client",
                  timeout_ms_));
}

bool RemoteClient::RobotGoesOn() const {
  if (is_probe_) return false;
  try {
    RemoteClient probe(address_, timeout_ms_, true);
    probe.Request(rcINFO);
    return true;
  } catch (const std::runtime_error&) {
    return false;
  }
}

void RemoteClient::ThrowLost(int error) const {
  const char* const why =
      RobotGoesOn()
          ? "but the robot goes on; it closes the connection of a client whose bytes are no "
            "packet, "
            "and of one that was silent for 10 s when all 8 places are taken and another one "
            "connects: connect again"
          : "and the robot does not answer any more: it seems that the run has ended. The last "
            "line of 'openr run' (\"ended by ...\") and 'ended_by' in its report say why";
  Throw(fmt::format("the connection was lost ({}), {}",
                    error == 0 ? "the robot closed it" : std::strerror(error), why));
}

void RemoteClient::ThrowMalformed() const {
  Throw(
      fmt::format("the answer is not as version {} of the protocol has it; is the client of the "
                  "robot's version?",
                  version_));
}

void RemoteClient::Send(const std::vector<uint8_t>& bytes) {
  for (size_t sent = 0; sent < bytes.size();) {
    const ssize_t n = send(socket_, bytes.data() + sent, bytes.size() - sent, MSG_NOSIGNAL);
    if (n > 0) {
      sent += static_cast<size_t>(n);
    } else if (errno == EAGAIN) {
      if (!WaitFor(POLLOUT)) ThrowSilent();
    } else if (errno != EINTR) {
      ThrowLost(errno);
    }
  }
}

void RemoteClient::ReceivePacket() {
  if (!ReceivePacketInTime()) ThrowSilent();
}

// Returns false when no whole packet has come within timeout_ms_.
bool RemoteClient::ReceivePacketInTime() {
  for (;;) {
    const RcFramer::Result result = framer_.Next();
    if (result == RcFramer::PACKET) return true;
    if (result == RcFramer::BROKEN) {
      Throw(fmt::format("this is no remote control: {}; is the port the one 'openr run' printed?",
                        framer_.Error()));
    }
    uint8_t bytes[RC_MAX_PACKET];
    if (!WaitFor(POLLIN)) return false;
    const ssize_t n = recv(socket_, bytes, sizeof bytes, 0);
    if (n > 0) {
      framer_.Take(bytes, static_cast<int>(n));
    } else if (n == 0 || (errno != EINTR && errno != EAGAIN)) {
      ThrowLost(n == 0 ? 0 : errno);
    }
  }
}

uint16_t RemoteClient::SendRequest(int command, const std::vector<uint8_t>& payload) {
  Send(MakePacket(version_, command, ++tag_, payload));
  return tag_;
}

RcAnswerHeader RemoteClient::ReceiveHeader() {
  RcAnswerHeader header;
  ReceivePacket();
  if (!header.Read(framer_)) ThrowMalformed();
  return header;
}

// Keeps the packet that was received last if it is an event.  Returns false if it is an answer.
bool RemoteClient::KeepEvent(const RcAnswerHeader& header) {
  if (header.header.command != rcEVENT) return false;
  const int begin = RC_ANSWER_HEADER_SIZE - RC_HEADER_SIZE;
  RcReader in(framer_.Payload() + begin, framer_.PayloadSize() - begin);
  RcEventHead head;
  head.Read(&in);
  if (in.HasFailed()) ThrowMalformed();
  Send(MakePacket(RC_VERSION_FILES, rcEVENT, header.header.tag, {}));  // lets the next ones come
  if (events_.size() == kEventsMax) events_.pop_front();
  events_.push_back({header.header.tag, header.frame, head.stream, head.leftOut,
                     std::vector<uint8_t>(in.Rest(), in.Rest() + in.RestSize())});
  return true;
}

uint16_t RemoteClient::Subscribe(RcStream stream, int period) {
  UseVersion(RC_VERSION_FILES);
  RequestWith(rcSUBSCRIBE, RcSubscribe{static_cast<Uint8>(stream), static_cast<Uint16>(period)});
  return tag_;
}

RemoteEvent RemoteClient::NextEvent() {
  while (events_.empty()) {
    if (!ReceivePacketInTime()) {
      Request(rcINFO);  // throws when the robot is gone
    } else if (RcAnswerHeader header; !header.Read(framer_) || !KeepEvent(header)) {
      ThrowMalformed();
    }
  }
  const RemoteEvent event = std::move(events_.front());
  events_.pop_front();
  return event;
}

RemoteAnswer RemoteClient::ReceiveAnswer(uint16_t tag) {
  RcAnswerHeader header = ReceiveHeader();
  while (KeepEvent(header)) header = ReceiveHeader();
  RemoteAnswer answer;
  answer.frame = header.frame;
  const int begin = RC_ANSWER_HEADER_SIZE - RC_HEADER_SIZE;
  answer.payload.assign(framer_.Payload() + begin, framer_.Payload() + framer_.PayloadSize());
  if (header.status != rcOK) {
    throw RemoteRefusal(header.status, header.frame, ErrorText(answer.payload));
  }
  if (header.header.tag != tag) ThrowMalformed();
  return answer;
}

RemoteAnswer RemoteClient::Request(int command, const std::vector<uint8_t>& payload) {
  return ReceiveAnswer(SendRequest(command, payload));
}

std::vector<RemoteAnswer> RemoteClient::RequestAll(
    int command, const std::vector<std::vector<uint8_t>>& payloads) {
  std::vector<uint16_t> tags;
  for (const auto& payload : payloads) tags.push_back(SendRequest(command, payload));
  std::vector<RemoteAnswer> answers;
  for (const uint16_t tag : tags) answers.push_back(ReceiveAnswer(tag));
  return answers;
}

std::vector<uint8_t> RemoteClient::BatchPayload(const std::vector<RemoteCall>& calls) const {
  std::vector<uint8_t> payload;
  for (const RemoteCall& call : calls) {
    const auto packet = MakePacket(version_, call.command, 0, call.payload);
    payload.insert(payload.end(), packet.begin(), packet.end());
  }
  return payload;
}

std::vector<RemoteReply> RemoteClient::Batch(const std::vector<RemoteCall>& calls) {
  UseVersion(RC_VERSION_FILES);
  return ReadBatch(Request(rcBATCH, BatchPayload(calls)), calls.size());
}

// Reads the packet that `framer` has found, an answer with the header `header`.
RemoteReply RemoteClient::ReadReply(const RcAnswerHeader& header, const RcFramer& framer) {
  const int begin = RC_ANSWER_HEADER_SIZE - RC_HEADER_SIZE;
  RemoteReply reply;
  reply.status = header.status;
  reply.answer.frame = header.frame;
  reply.answer.payload.assign(framer.Payload() + begin, framer.Payload() + framer.PayloadSize());
  if (reply.status != rcOK) reply.error = ErrorText(reply.answer.payload);
  return reply;
}

std::vector<RemoteReply> RemoteClient::ReadBatch(const RemoteAnswer& answer, size_t count) const {
  std::vector<RemoteReply> replies;
  RcFramer framer;
  framer.Take(answer.payload.data(), static_cast<int>(answer.payload.size()));
  while (framer.Next() == RcFramer::PACKET) {
    RcAnswerHeader header;
    if (!header.Read(framer)) ThrowMalformed();
    replies.push_back(ReadReply(header, framer));
  }
  if (replies.size() != count) ThrowMalformed();
  return replies;
}

RemoteDevices::RemoteDevices(RemoteClient* client, RcDeviceKind kind) {
  const RcInfo info = client->Read<RcInfo>(client->Request(rcINFO));
  const int counts[] = {info.numJoints, info.numLeds, info.numEars, info.numBinary, info.numOther};
  std::vector<std::vector<uint8_t>> questions;
  for (int i = 0; i < counts[kind]; ++i) {
    questions.push_back({static_cast<uint8_t>(kind), static_cast<uint8_t>(i)});
  }
  for (const RemoteAnswer& answer : client->RequestAll(rcDESCRIBE, questions)) {
    all_.push_back(client->Read<RcDescription>(answer));
  }
}

int RemoteDevices::Find(const std::string& name) const {
  std::string known;
  for (size_t i = 0; i < all_.size(); ++i) {
    const RcDescription& device = all_[i];
    if (name == device.name || name == device.title || name == device.locator ||
        name == std::to_string(i)) {
      return static_cast<int>(i);
    }
    known += fmt::format("\n  {} {}", i, device.name);
  }
  throw std::runtime_error(fmt::format("the robot has no '{}'; there are{}", name, known));
}

}  // namespace openr_host
