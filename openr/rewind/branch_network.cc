#include "openr/rewind/branch_network.h"

#include <utility>

#include "runtime/base/assert.h"

namespace openr_host {

void BranchNetwork::Repeat(std::deque<LoggedInput> inputs) {
  repeats_ = true;
  inputs_ = std::move(inputs);
}

void BranchNetwork::RepeatFrom(std::function<std::vector<NetworkEvent>()> next_events) {
  repeats_ = true;
  next_events_ = std::move(next_events);
}

void BranchNetwork::GoOn() {
  repeats_ = false;
  next_events_ = nullptr;
  inputs_.clear();
  for (const auto& [handle, socket] : sockets_) OpenAgain(handle, socket);
}

void BranchNetwork::OpenAgain(NetHandle handle, const Socket& socket) {
  if (socket.has_address) PassingNetwork::SelectAddress(handle, socket.address);
  switch (socket.kind) {
    case Socket::Kind::kNew:
      break;
    case Socket::Kind::kListener:
      PassingNetwork::Listen(handle, socket.port);
      for (const NetHandle accepted : socket.accepts) PassingNetwork::Accept(handle, accepted);
      break;
    // A TCP connection cannot go on in this run, because its other end was connected to the
    // original run.  So the robot gets an event that tells it that the connection is broken.
    case Socket::Kind::kStream: {
      NetworkEvent broken;
      broken.kind = NetworkEvent::Kind::kFailed;
      broken.handle = handle;
      broken.error = NetError::kReset;
      broken_.push_back(broken);
      break;
    }
    case Socket::Kind::kUdp:
      PassingNetwork::Bind(handle, socket.port, socket.any_port);
      if (socket.datagrams > 0) PassingNetwork::ReceiveFrom(handle, socket.datagrams);
      break;
    case Socket::Kind::kName:
      PassingNetwork::Resolve(handle, socket.name);
      break;
    case Socket::Kind::kAddress:
      PassingNetwork::ResolveAddress(handle, socket.address);
      break;
  }
}

void BranchNetwork::SelectAddress(NetHandle handle, uint32_t ip) {
  sockets_[handle].has_address = true;
  sockets_[handle].address = ip;
  if (!repeats_) PassingNetwork::SelectAddress(handle, ip);
}

void BranchNetwork::Listen(NetHandle listener, uint16_t port) {
  sockets_[listener].kind = Socket::Kind::kListener;
  sockets_[listener].port = port;
  if (!repeats_) PassingNetwork::Listen(listener, port);
}

void BranchNetwork::Accept(NetHandle listener, NetHandle handle) {
  sockets_[listener].accepts.push_back(handle);
  if (!repeats_) PassingNetwork::Accept(listener, handle);
}

void BranchNetwork::Connect(NetHandle handle, uint16_t local_port, NetAddress remote) {
  sockets_[handle].kind = Socket::Kind::kStream;
  if (!repeats_) PassingNetwork::Connect(handle, local_port, remote);
}

void BranchNetwork::Send(NetHandle handle, const void* data, size_t size) {
  if (!repeats_) PassingNetwork::Send(handle, data, size);
}

void BranchNetwork::Receive(NetHandle handle, size_t size_max) {
  if (!repeats_) PassingNetwork::Receive(handle, size_max);
}

void BranchNetwork::Close(NetHandle handle) {
  if (!repeats_) PassingNetwork::Close(handle);
}

void BranchNetwork::Bind(NetHandle handle, uint16_t port, bool any_port) {
  Socket& socket = sockets_[handle];
  socket.kind = Socket::Kind::kUdp;
  socket.port = port;
  socket.any_port = any_port;
  if (!repeats_) PassingNetwork::Bind(handle, port, any_port);
}

void BranchNetwork::SendTo(NetHandle handle, NetAddress remote, const void* data, size_t size) {
  if (!repeats_) PassingNetwork::SendTo(handle, remote, data, size);
}

void BranchNetwork::ReceiveFrom(NetHandle handle, size_t count_max) {
  sockets_[handle].datagrams = count_max;
  if (!repeats_) PassingNetwork::ReceiveFrom(handle, count_max);
}

void BranchNetwork::Resolve(NetHandle handle, const std::string& name) {
  sockets_[handle].kind = Socket::Kind::kName;
  sockets_[handle].name = name;
  if (!repeats_) PassingNetwork::Resolve(handle, name);
}

void BranchNetwork::ResolveAddress(NetHandle handle, uint32_t ip) {
  sockets_[handle].kind = Socket::Kind::kAddress;
  sockets_[handle].address = ip;
  if (!repeats_) PassingNetwork::ResolveAddress(handle, ip);
}

void BranchNetwork::Drop(NetHandle handle, bool reset) {
  sockets_.erase(handle);
  for (auto& [listener, socket] : sockets_) std::erase(socket.accepts, handle);
  std::erase_if(broken_, [handle](const NetworkEvent& event) { return event.handle == handle; });
  if (!repeats_) PassingNetwork::Drop(handle, reset);
}

// Updates sockets_, the record of the robot's sockets, after `event`, which Poll() returns to the
// robot now.  GoOn() uses this record to open the sockets again.
void BranchNetwork::Follow(const NetworkEvent& event) {
  switch (event.kind) {
    case NetworkEvent::Kind::kAccepted:
      for (auto& [handle, socket] : sockets_) std::erase(socket.accepts, event.handle);
      sockets_[event.handle].kind = Socket::Kind::kStream;
      break;
    case NetworkEvent::Kind::kDatagram:
      sockets_[event.handle].datagrams = 0;
      break;
    case NetworkEvent::Kind::kResolved:
    case NetworkEvent::Kind::kFailed:
    case NetworkEvent::Kind::kClosed:
      // Marks the socket as unused, so that GoOn() does not open it again: its connection has
      // ended, an error has come, or its name look-up was answered.  The robot can then only drop
      // the socket.
      sockets_[event.handle].kind = Socket::Kind::kNew;
      break;
    default:
      break;
  }
}

std::vector<NetworkEvent> BranchNetwork::Poll() {
  ++poll_;
  std::vector<NetworkEvent> events;
  if (repeats_ && next_events_) {
    events = next_events_();
  } else if (repeats_) {
    if (!inputs_.empty() && inputs_.front().poll == poll_) {
      events = std::move(inputs_.front().events);
      inputs_.pop_front();
    }
    ASSERT(inputs_.empty() || inputs_.front().poll > poll_);
  } else {
    events = std::exchange(broken_, {});
    std::vector<NetworkEvent> news = PassingNetwork::Poll();
    events.insert(events.end(), news.begin(), news.end());
  }
  for (const NetworkEvent& event : events) Follow(event);
  if (!repeats_ && !events.empty()) {
    LoggedInput input;
    input.robot = robot_;
    input.poll = poll_;
    input.events = events;
    log_.Add(std::move(input));
  }
  return events;
}

}  // namespace openr_host
