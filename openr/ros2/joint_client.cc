#include "openr/ros2/joint_client.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "RemoteProtocol.h"
#include "virtualrobot/base/det_math.h"

namespace openr_host {
namespace {

// Address of a JointClient, a client inside this program, as the robot sees it.  The port is 1,
// because no client on the network has this port.
constexpr NetAddress kRemote = {0x7f000001, 1};

constexpr double kCentidegPerRad = 100 * Degrees(1);
// Largest joint position that is sent to a robot, one turn in either direction: a larger number
// might not fit into a request.  No joint can turn so far, and the robot applies its own limits to
// each joint.
constexpr double kPositionMax_rad = 2 * kPi;
constexpr double kSpeedMax_rad_s = 1000;

NetworkEvent EventOf(NetworkEvent::Kind kind, NetHandle handle) {
  NetworkEvent event;
  event.kind = kind;
  event.handle = handle;
  return event;
}

}  // namespace

void JointClient::SetTargets(const std::map<int, JointTarget>& targets) {
  for (const auto& [joint, target] : targets) {
    JointTarget& wanted = wanted_[joint];
    // If the new target of the joint has no speed limit, keeps the speed limit of the old target,
    // because this limit has not been sent to the robot yet.
    const double speed_rad_s = wanted.speed_rad_s;
    wanted = target;
    if (target.speed_rad_s <= 0) wanted.speed_rad_s = speed_rad_s;
  }
}

void JointClient::Listen(NetHandle listener, uint16_t port) {
  if (port == RC_PORT) {
    listener_ = listener;
    accepts_.clear();
  }
  PassingNetwork::Listen(listener, port);
}

void JointClient::Accept(NetHandle listener, NetHandle handle) {
  if (listener == listener_) accepts_.push_back(handle);
  PassingNetwork::Accept(listener, handle);
}

void JointClient::Send(NetHandle handle, const void* data, size_t size) {
  if (handle != handle_) return PassingNetwork::Send(handle, data, size);
  unconfirmed_bytes_ += size;
  const auto* bytes = static_cast<const Uint8*>(data);
  while (size > 0 && !is_broken_) {
    const size_t count = std::min(size, static_cast<size_t>(framer_.Room()));
    framer_.Append(bytes, static_cast<int>(count));
    bytes += count;
    size -= count;
    ReadAnswers();
  }
}

void JointClient::ReadAnswers() {
  for (;;) {
    const RcFramer::Result result = framer_.Next();
    if (result == RcFramer::NEEDS_MORE) return;
    RcAnswerHeader header;
    is_broken_ = result == RcFramer::BROKEN || !header.Read(framer_);
    if (is_broken_) return refused_("what listens on the port of the remote control is another");
    --unanswered_;
    if (header.status == rcOK) continue;
    constexpr int kBegin = RC_ANSWER_HEADER_SIZE - RC_HEADER_SIZE;
    RcReader reader(framer_.Payload() + kBegin, framer_.PayloadSize() - kBegin);
    refused_(reader.String());
  }
}

void JointClient::Receive(NetHandle handle, size_t size_max) {
  if (handle != handle_) return PassingNetwork::Receive(handle, size_max);
  wants_ = size_max;
}

void JointClient::Close(NetHandle handle) {
  if (handle != handle_) return PassingNetwork::Close(handle);
  is_closing_ = true;
}

void JointClient::Drop(NetHandle handle, bool reset) {
  if (handle == listener_) listener_ = 0;
  std::erase(accepts_, handle);
  if (handle == handle_) return EndConnection();
  PassingNetwork::Drop(handle, reset);
}

void JointClient::Forget() {
  listener_ = 0;
  accepts_.clear();
  GiveUp();
  EndConnection();
  PassingNetwork::Forget();
}

void JointClient::EndConnection() {
  handle_ = 0;
  out_.clear();
  unanswered_ = 0;
  unconfirmed_bytes_ = 0;
  wants_ = 0;
  is_closing_ = false;
  is_broken_ = false;
  framer_.Reset();
}

// Connects this client to the robot's remote control.  The remote control waits for clients with
// Accept().  This function reports in `events` that the oldest waiting Accept() has a connection,
// and removes this Accept() from the real network.  Returns false if no Accept() waits.
bool JointClient::AnswerAccept(std::vector<NetworkEvent>* events) {
  if (listener_ == 0 || accepts_.empty()) return false;
  const NetHandle handle = accepts_.front();
  accepts_.pop_front();
  PassingNetwork::Drop(handle, false);
  handle_ = handle;
  events->push_back(EventOf(NetworkEvent::Kind::kAccepted, handle));
  events->back().remote = kRemote;
  return true;
}

void JointClient::Request(int command, int joint, double value) {
  uint8_t bytes[RC_MAX_PACKET];
  RcWriter writer(bytes, sizeof bytes);
  writer.U16(RC_MAGIC);
  writer.U16(RC_HEADER_SIZE + 5);
  writer.U8(RC_VERSION);
  writer.U8(static_cast<Uint32>(command));
  writer.U16(0);  // the tag is not needed, because answers come in order
  writer.U8(static_cast<Uint32>(joint));
  writer.S32(static_cast<Sint32>(std::lround(value * kCentidegPerRad)));
  out_.append(reinterpret_cast<const char*>(bytes), static_cast<size_t>(writer.Size()));
  ++unanswered_;
}

void JointClient::WriteRequests() {
  // Waits for the answers to earlier requests, so that of several targets for a joint only the
  // newest is sent.
  if (unanswered_ > 0) return;
  for (const auto& [joint, target] : std::exchange(wanted_, {})) {
    // Sends the limit of speed first, so that it holds for this movement.
    if (target.speed_rad_s > 0)
      Request(rcSPEED, joint, std::min(target.speed_rad_s, kSpeedMax_rad_s));
    Request(rcMOVE, joint, std::clamp(target.position_rad, -kPositionMax_rad, kPositionMax_rad));
  }
}

std::vector<NetworkEvent> JointClient::Poll() {
  std::vector<NetworkEvent> events = PassingNetwork::Poll();
  for (const NetworkEvent& event : events) std::erase(accepts_, event.handle);
  // Connects to the robot's remote control only when there is a first joint target, so that a run
  // without commands from ROS 2 has no connection.
  if (handle_ == 0 && (wanted_.empty() || !AnswerAccept(&events))) return events;
  if (unconfirmed_bytes_ > 0) {
    events.push_back(EventOf(NetworkEvent::Kind::kSent, handle_));
    events.back().count = std::exchange(unconfirmed_bytes_, 0);
  }
  if (is_closing_) {
    events.push_back(EventOf(NetworkEvent::Kind::kClosed, handle_));
    EndConnection();
    return events;
  }
  // After an invalid answer, sends no more requests and ends the connection below, because the
  // object that listens on the port of the remote control is then another object.
  if (!is_broken_) WriteRequests();
  if (wants_ > 0 && (is_broken_ || !out_.empty())) {
    events.push_back(EventOf(NetworkEvent::Kind::kReceived, handle_));
    NetworkEvent& event = events.back();
    if (is_broken_) event.kind = NetworkEvent::Kind::kEnd;
    event.bytes = out_.substr(0, wants_);
    out_.erase(0, event.bytes.size());
    if (is_broken_) event.bytes.clear();
    wants_ = 0;
  }
  return events;
}

}  // namespace openr_host
