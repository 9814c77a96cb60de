// The part of Connection that handles packets, requests and events.
#include "openr/remote/connection.h"

#include <fmt/format.h>

#include <utility>

#include "openr/remote/tcp_stream.h"

namespace openr::remote {
namespace {

// Returns the version of the protocol that a request must have: the first version that knows the
// command.
int VersionFor(int command) {
  switch (command) {
    case rcINFO:
    case rcDESCRIBE:
    case rcGET:
    case rcMOVE:
    case rcSPEED:
    case rcACCEL:
    case rcLED:
    case rcEAR:
    case rcSENSORS:
    case rcMTN_PLAY:
    case rcMTN_STOP:
      return RC_VERSION;
    default:
      return RC_VERSION_FILES;
  }
}

Bytes MakePacket(int command, RequestId id, const Bytes& payload, int version = 0) {
  Bytes packet(RC_HEADER_SIZE + payload.size());
  RcWriter writer(packet.data(), static_cast<int>(packet.size()));
  for (int i = 0; i < RC_HEADER_SIZE; ++i) writer.U8(0);
  writer.Bytes(payload.data(), static_cast<int>(payload.size()));
  writer.PutHeader(command, id, version != 0 ? version : VersionFor(command));
  return packet;
}

// Makes the answer of the robot from the packet that `framer` has found last.
Answer AnswerFrom(const RcAnswerHeader& header, const RcFramer& framer) {
  const int begin = RC_ANSWER_HEADER_SIZE - RC_HEADER_SIZE;
  Answer answer;
  answer.frame = header.frame;
  answer.status = header.status;
  const Uint8* const bytes = framer.Payload() + begin;
  const int size = framer.PayloadSize() - begin;
  if (answer.status != rcOK) {
    answer.error = RcReader(bytes, size).String();
  } else {
    answer.payload.assign(bytes, bytes + size);
  }
  return answer;
}

}  // namespace

Connection::Connection(const Address& address, Options options)
    : Connection(address, std::move(options), false) {}

Connection::Connection(const Address& address, Options options, bool is_probe)
    : address_(address),
      options_(std::move(options)),
      is_probe_(is_probe),
      stream_(std::make_unique<TcpStream>(address, options_.timeout)) {
  if (!options_.token.empty()) ShowToken();
}

Connection::~Connection() = default;

void Connection::ShowToken() {
  Bytes payload(1 + options_.token.size());
  RcWriter writer(payload.data(), static_cast<int>(payload.size()));
  writer.String(options_.token);
  const Answer answer = WaitForAny(Send(rcTOKEN, payload));
  // Accepts two refusals by which the robot says that it does not know the command TOKEN, because
  // such a robot needs no token.
  if (answer.status == rcerrorUNKNOWN_COMMAND || answer.status == rcerrorVERSION) return;
  if (answer.status != rcOK) throw Error(answer.status, answer.frame, answer.error);
}

// ---- Functions that throw errors

void Connection::Throw(ErrorCode code, const std::string& text, const std::string& advice) const {
  throw Error(code, fmt::format("{}: {}", address_.Text(), text), advice);
}

void Connection::ThrowSilent() const {
  Throw(ErrorCode::kTimeout,
        fmt::format("connected, but no answer within {} ms", options_.timeout.count()),
        "the robot is still booting, or serves as many clients as it can (8): wait (--timeout), or "
        "end another client");
}

// Returns whether the robot answers on a new connection.  Called when this connection was lost: if
// the robot answers, only this connection has ended and not the whole run, and the error text says
// so.
bool Connection::RobotGoesOn() const {
  if (is_probe_) return false;
  try {
    Connection(address_, options_, true).Request(rcINFO);
    return true;
  } catch (const Error& error) {
    // A refusal counts as an answer, because it shows that the robot still runs, but has all the
    // clients that it can serve.
    return error.code() == ErrorCode::kRefused;
  }
}

void Connection::ThrowLost() const {
  const std::string text = fmt::format("the connection was lost ({}), ", stream_->why_lost());
  if (RobotGoesOn()) {
    Throw(ErrorCode::kLost, text + "but the robot goes on",
          "it closes the connection of a client whose bytes are no packet, and of one that was "
          "silent for 10 s when all 8 places are taken and another one connects: connect again");
  }
  Throw(ErrorCode::kLost,
        text + "and the robot does not answer any more: it seems that the run has ended",
        "the last line of 'openr run' (\"ended by ...\") and 'ended_by' in its report say why");
}

void Connection::ThrowMalformed() const {
  Throw(ErrorCode::kProtocol, "the answer is not as versions 1 and 2 of the protocol have it",
        "is the client of the robot's version?");
}

// ---- Functions that send and receive packets

void Connection::SendBytes(const Bytes& bytes) {
  switch (stream_->Send(bytes.data(), bytes.size(), Clock::now() + options_.timeout)) {
    case TcpStream::Result::kGood:
      return;
    case TcpStream::Result::kTimeout:
      ThrowSilent();
    case TcpStream::Result::kLost:
      ThrowLost();
  }
}

// Receives a packet.  Returns false if no complete packet has arrived by `deadline`.
bool Connection::ReceivePacket(Clock::time_point deadline) {
  for (;;) {
    const RcFramer::Result result = framer_.Next();
    if (result == RcFramer::PACKET) return true;
    if (result == RcFramer::BROKEN) {
      Throw(ErrorCode::kProtocol, "this is no remote control: " + framer_.Error(),
            "is the port the one 'openr run' printed?");
    }
    uint8_t bytes[RC_MAX_PACKET];
    size_t count = 0;
    switch (stream_->Receive(bytes, sizeof bytes, deadline, &count)) {
      case TcpStream::Result::kGood:
        framer_.Append(bytes, static_cast<int>(count));
        break;
      case TcpStream::Result::kTimeout:
        return false;
      case TcpStream::Result::kLost:
        ThrowLost();
    }
  }
}

// Stores the packet that was received last.  An event is added to the events that NextEvent() will
// return; an answer is stored with its request.
void Connection::HandlePacket() {
  RcAnswerHeader header;
  if (!header.Read(framer_)) ThrowMalformed();
  if (header.header.command == rcEVENT) {
    KeepEvent(header);
  } else {
    StoreAnswer(header);
  }
}

void Connection::StoreAnswer(const RcAnswerHeader& header) {
  const auto found = pending_.find(header.header.tag);
  if (found == pending_.end()) {
    Answer answer = AnswerFrom(header, framer_);
    // Throws an exception for an answer that belongs to no request.  The robot sends such an answer
    // when it has received bytes that are no packet, or when it has all the clients that it can
    // serve.
    if (answer.status != rcOK) throw Error(answer.status, answer.frame, answer.error);
    ThrowMalformed();
  }
  if (found->second.is_dropped) {
    pending_.erase(found);
  } else {
    found->second.answer = AnswerFrom(header, framer_);
  }
}

void Connection::KeepEvent(const RcAnswerHeader& header) {
  const int begin = RC_ANSWER_HEADER_SIZE - RC_HEADER_SIZE;
  RcReader in(framer_.Payload() + begin, framer_.PayloadSize() - begin);
  RcEventHead head;
  head.Read(&in);
  if (in.HasFailed()) ThrowMalformed();
  if (events_.size() == kEventsMax) events_.pop_front();
  events_.push_back({header.header.tag, header.frame, head.stream, head.leftOut,
                     Bytes(in.Rest(), in.Rest() + in.RestSize())});
  // Tells the robot that the event has arrived.  The robot may then send the next events.
  SendBytes(MakePacket(rcEVENT, header.header.tag, {}));
}

// ---- Functions that send requests and wait for their answers

RequestId Connection::Send(int command, const Bytes& payload, int version) {
  // Never gives a request the tag 0, because the robot uses 0 in packets that answer no request.
  do {
    ++last_id_;
  } while (last_id_ == 0 || pending_.contains(last_id_));
  SendBytes(MakePacket(command, last_id_, payload, version));
  pending_[last_id_].sent = Clock::now();
  return last_id_;
}

bool Connection::IsAnswered(RequestId id) {
  while (ReceivePacket(Clock::time_point{})) HandlePacket();
  const Pending& pending = pending_.at(id);
  if (!pending.answer && Clock::now() - pending.sent > options_.timeout) ThrowSilent();
  return pending.answer.has_value();
}

Answer Connection::WaitForAny(RequestId id) {
  const Clock::time_point deadline = Clock::now() + options_.timeout;
  while (!pending_.at(id).answer) {
    // Looks at the clock even if packets arrive, because all of them may be events, and this loop
    // must end even if the answer never comes.
    if (Clock::now() > deadline || !ReceivePacket(deadline)) ThrowSilent();
    HandlePacket();
  }
  Answer answer = *std::move(pending_.at(id).answer);
  pending_.erase(id);
  frame_ = answer.frame;
  return answer;
}

Answer Connection::Wait(RequestId id) {
  Answer answer = WaitForAny(id);
  if (answer.status != rcOK) throw Error(answer.status, answer.frame, answer.error);
  return answer;
}

void Connection::Drop(RequestId id) {
  Pending& pending = pending_.at(id);
  pending.is_dropped = true;
  if (pending.answer) pending_.erase(id);
}

Answer Connection::Request(int command, const Bytes& payload, int version) {
  return Wait(Send(command, payload, version));
}

std::vector<Answer> Connection::RequestAll(int command, const std::vector<Bytes>& payloads) {
  std::deque<RequestId> ids;
  std::vector<Answer> answers;
  for (size_t sent = 0; answers.size() < payloads.size();) {
    while (sent < payloads.size() && ids.size() < kInFlight) {
      ids.push_back(Send(command, payloads[sent]));
      sent += 1;
    }
    answers.push_back(WaitForAny(ids.front()));
    ids.pop_front();
  }
  // Throws an error only now, when all answers have come, because an answer for which nobody waits
  // would stay in pending_.
  for (const Answer& answer : answers) {
    if (answer.status != rcOK) throw Error(answer.status, answer.frame, answer.error);
  }
  return answers;
}

RequestId Connection::SendBatch(const std::vector<Call>& calls) {
  Bytes payload;
  for (const Call& call : calls) {
    // All requests of a batch have the tag 0, because the answers come in the order of the
    // requests.
    const Bytes packet = MakePacket(call.command, 0, call.payload);
    payload.insert(payload.end(), packet.begin(), packet.end());
  }
  return Send(rcBATCH, payload);
}

int Connection::descriptor() const { return stream_->descriptor(); }

std::optional<Answer> Connection::TakeAnswer(RequestId id) {
  Pending& pending = pending_.at(id);
  if (!pending.answer) return std::nullopt;
  Answer answer = *std::move(pending.answer);
  pending_.erase(id);
  return answer;
}

std::vector<Answer> Connection::WaitForBatch(RequestId id, size_t count) {
  return ReadBatch(Wait(id), count);
}

std::vector<Answer> Connection::ReadBatch(const Answer& answer, size_t count) const {
  std::vector<Answer> answers;
  RcFramer framer;
  framer.Append(answer.payload.data(), static_cast<int>(answer.payload.size()));
  while (framer.Next() == RcFramer::PACKET) {
    RcAnswerHeader header;
    if (!header.Read(framer)) ThrowMalformed();
    answers.push_back(AnswerFrom(header, framer));
  }
  if (answers.size() != count) ThrowMalformed();
  return answers;
}

std::vector<Answer> Connection::Batch(const std::vector<Call>& calls) {
  return WaitForBatch(SendBatch(calls), calls.size());
}

// ---- Functions that receive events

RequestId Connection::Subscribe(RcStream stream, int period) {
  const RequestId id = Send(
      rcSUBSCRIBE, BytesOf(RcSubscribe{static_cast<Uint8>(stream), static_cast<Uint16>(period)}));
  Wait(id);
  return id;
}

void Connection::Unsubscribe(RcStream stream) {
  Request(rcUNSUBSCRIBE, {static_cast<uint8_t>(stream)});
}

std::optional<Event> Connection::NextEvent(Clock::time_point deadline) {
  while (events_.empty()) {
    if (!ReceivePacket(deadline)) return std::nullopt;
    HandlePacket();
  }
  Event event = std::move(events_.front());
  events_.pop_front();
  return event;
}

Event Connection::NextEvent() {
  for (;;) {
    std::optional<Event> event = NextEvent(Clock::now() + options_.timeout);
    if (event) return *std::move(event);
    Request(rcINFO);  // tests whether the robot still answers; throws if it does not
  }
}

}  // namespace openr::remote
