#include "testing/tcp_client.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <utility>

#include "runtime/base/assert.h"
#include "runtime/core/system.h"

namespace openr::testing {

using openr_host::kFrameUs;
using openr_host::MessageClass;
using openr_host::NetworkEvent;
using openr_host::OwnedMessage;

namespace {

constexpr uint16_t kFirstPort = 40000;
constexpr size_t kReceiveMax = 1 << 20;

}  // namespace

TcpClient::TcpClient(std::shared_ptr<openr_host::LoopbackHub> hub, uint32_t own_ip,
                     uint32_t robot_ip)
    : network_(std::move(hub)), robot_ip_(robot_ip) {
  network_.Attach(own_ip);
  host().set_system(true);
  poll_entry_ = AddExtra("Poll", [this](void*) {
    poll_posted_ = false;
    Poll();
  });
}

TcpClient& TcpClient::Connect(uint16_t port, Place place) {
  return Add({Kind::kConnect, place, "", port});
}
TcpClient& TcpClient::Send(std::string bytes, Place place) {
  return Add({Kind::kSend, place, std::move(bytes)});
}
TcpClient& TcpClient::Hear(std::string bytes, Place place) {
  return Add({Kind::kHear, place, std::move(bytes)});
}
TcpClient& TcpClient::HearBytes(size_t count, Place place) {
  return Add({Kind::kHearBytes, place, "", count});
}
TcpClient& TcpClient::HearEnd(Place place) { return Add({Kind::kHearEnd, place}); }
TcpClient& TcpClient::Close(Place place) { return Add({Kind::kClose, place}); }
TcpClient& TcpClient::Reset(Place place) { return Add({Kind::kReset, place}); }

TcpClient& TcpClient::Add(Step step) {
  script_.push_back(std::move(step));
  PostPoll();
  return *this;
}

const Place& TcpClient::place() const {
  ASSERT(!done());
  return script_.front().place;
}

std::string TcpClient::WaitsFor() const {
  if (script_.empty()) return "";
  const Step& step = script_.front();
  const std::string rest = ::testing::PrintToString(heard_.substr(passed_));
  switch (step.kind) {
    case Kind::kConnect:
      return fmt::format("for somebody to listen on port {}", step.count);
    case Kind::kHear:
      return fmt::format("to hear {}, has heard {}", ::testing::PrintToString(step.bytes), rest);
    case Kind::kHearBytes:
      return fmt::format("to hear {} bytes, has heard {}", step.count, rest);
    case Kind::kHearEnd:
      return fmt::format("for the end of the connection, has heard {}", rest);
    default:
      return "for the next frame";
  }
}

// Posts a message to the client itself for the next frame boundary, because the client acts only at
// frame boundaries.  The handler of the message calls Poll(), which handles events of the network
// and goes on with the script.
void TcpClient::PostPoll() {
  if (std::exchange(poll_posted_, true)) return;
  const openr_host::CurrentScope scope(&system(), &host());
  const int64_t now_us = system().now_us();
  OwnedMessage message = system().NewMessage(host().id, poll_entry_);
  message->message_class = MessageClass::kInput;
  system().Post(std::move(message), kFrameUs - now_us % kFrameUs);
}

void TcpClient::Poll() {
  for (const NetworkEvent& event : network_.Poll()) {
    if (event.handle == handle_) StoreEvent(event);
  }
  while (!script_.empty() && Do(script_.front())) script_.pop_front();
  if (!script_.empty() || (connected_ && !ended_)) PostPoll();
}

void TcpClient::StoreEvent(const NetworkEvent& event) {
  using EventKind = NetworkEvent::Kind;
  switch (event.kind) {
    case EventKind::kConnected:
      connecting_ = false;
      connected_ = true;
      network_.Receive(handle_, kReceiveMax);
      break;
    case EventKind::kReceived:
      heard_ += event.bytes;
      network_.Receive(handle_, kReceiveMax);
      break;
    case EventKind::kEnd:
      ended_ = true;
      break;
    case EventKind::kFailed:
      broken_ = connected_;
      ended_ = connected_;
      connecting_ = false;
      connected_ = false;
      break;
    default:
      break;
  }
}

// Does as much of `step` as is possible at this frame boundary.  Returns true when the step is
// finished.
bool TcpClient::Do(const Step& step) {
  const size_t left = heard_.size() - passed_;
  switch (step.kind) {
    case Kind::kConnect:
      return DoConnect(step);
    case Kind::kSend:
      network_.Send(handle_, step.bytes.data(), step.bytes.size());
      return true;
    case Kind::kHear: {
      const size_t at = heard_.find(step.bytes, passed_);
      if (at == std::string::npos) return false;
      passed_ = at + step.bytes.size();
      return true;
    }
    case Kind::kHearBytes:
      if (left < step.count) return false;
      passed_ += step.count;
      return true;
    case Kind::kHearEnd:
      return ended_;
    case Kind::kClose:
      network_.Close(handle_);
      break;
    case Kind::kReset:
      network_.Drop(handle_, true);
      break;
  }
  connected_ = false;
  return true;
}

bool TcpClient::DoConnect(const Step& step) {
  if (connected_) return true;
  if (connecting_) return false;  // the robot has not answered yet; a later Poll() gets its answer
  connecting_ = true;
  ended_ = broken_ = false;
  ++handle_;
  network_.Connect(handle_, static_cast<uint16_t>(kFirstPort + handle_),
                   {robot_ip_, static_cast<uint16_t>(step.count)});
  return false;
}

}  // namespace openr::testing
