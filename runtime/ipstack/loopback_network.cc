#include "runtime/ipstack/loopback_network.h"

#include <algorithm>
#include <utility>

namespace openr_host {

LoopbackNetwork::LoopbackNetwork(std::shared_ptr<LoopbackHub> hub) : hub_(std::move(hub)) {}

LoopbackNetwork::~LoopbackNetwork() {
  while (!connections_.empty()) Drop(connections_.begin()->first, true);
  while (!listeners_.empty()) Drop(listeners_.begin()->first, true);
  LeaveHub();
}

// Removes this host from the hosts of the hub, unless another host has the same address now.
void LoopbackNetwork::LeaveHub() {
  const auto self = hub_->hosts_.find(ip_);
  if (self != hub_->hosts_.end() && self->second == this) hub_->hosts_.erase(self);
}

void LoopbackNetwork::Attach(uint32_t ip) {
  LeaveHub();
  ip_ = ip;
  hub_->hosts_[ip] = this;
}

LoopbackNetwork* LoopbackNetwork::HostAt(uint32_t ip) {
  if (ip == ip_ || ip >> 24 == 127) return this;
  const auto found = hub_->hosts_.find(ip);
  return found == hub_->hosts_.end() ? nullptr : found->second;
}

LoopbackNetwork::Listener* LoopbackNetwork::ListenerOn(uint16_t port) {
  for (auto& [handle, listener] : listeners_) {
    if (listener.port == port) return &listener;
  }
  return nullptr;
}

void LoopbackNetwork::Add(NetworkEvent::Kind kind, NetHandle handle, NetError error) {
  NetworkEvent event;
  event.kind = kind;
  event.handle = handle;
  event.error = error;
  events_.push_back(std::move(event));
}

void LoopbackNetwork::Listen(NetHandle handle, uint16_t port) {
  if (ListenerOn(port) != nullptr) {
    Add(NetworkEvent::Kind::kFailed, handle, NetError::kAddressInUse);
    return;
  }
  listeners_[handle].port = port;
}

void LoopbackNetwork::Accept(NetHandle listener, NetHandle handle) {
  const auto found = listeners_.find(listener);
  // No listener, because Listen() has failed and added an event kFailed.
  if (found == listeners_.end()) return;
  found->second.accepts.push_back(handle);
}

void LoopbackNetwork::MatchAccepts(Listener* listener) {
  while (!listener->accepts.empty() && !listener->backlog.empty()) {
    const NetHandle handle = listener->accepts.front();
    const Pending pending = listener->backlog.front();
    listener->accepts.pop_front();
    listener->backlog.pop_front();
    Connection& connection = connections_[handle];
    connection.link = pending.link;
    connection.side = 1;
    Add(NetworkEvent::Kind::kAccepted, handle);
    events_.back().remote = pending.remote;
  }
}

void LoopbackNetwork::Connect(NetHandle handle, uint16_t local_port, NetAddress remote) {
  LoopbackNetwork* const host = HostAt(remote.ip);
  if (host == nullptr) {
    Add(NetworkEvent::Kind::kFailed, handle, NetError::kHostUnreachable);
    return;
  }
  Listener* const listener = host->ListenerOn(remote.port);
  if (listener == nullptr || listener->backlog.size() >= kBacklog) {
    Add(NetworkEvent::Kind::kFailed, handle, NetError::kRefused);
    return;
  }
  Connection& connection = connections_[handle];
  connection.link = std::make_shared<Link>();
  listener->backlog.push_back({connection.link, {ip_, local_port}});
  Add(NetworkEvent::Kind::kConnected, handle);
}

void LoopbackNetwork::Send(NetHandle handle, const void* data, size_t size) {
  const auto found = connections_.find(handle);
  if (found == connections_.end()) return;
  found->second.out.append(static_cast<const char*>(data), size);
  Push(handle, &found->second);
}

// Moves the bytes that wait on `connection` into the pipe to the peer, as many as fit.  Adds an
// event that tells the sender how many bytes were moved.
void LoopbackNetwork::Push(NetHandle handle, Connection* connection) {
  Pipe& pipe = connection->peer();
  if (pipe.gone && !connection->out.empty()) connection->link->reset = true;
  if (connection->link->reset) return;
  const size_t room = kWindowBytes - std::min(kWindowBytes, pipe.bytes.size());
  const size_t count =
      pipe.discards ? connection->out.size() : std::min(room, connection->out.size());
  if (count > 0) {
    if (!pipe.discards) pipe.bytes.append(connection->out, 0, count);
    connection->out.erase(0, count);
    Add(NetworkEvent::Kind::kSent, handle);
    events_.back().count = count;
  }
  if (connection->closing && connection->out.empty()) pipe.ended = true;
}

void LoopbackNetwork::Receive(NetHandle handle, size_t size_max) {
  const auto found = connections_.find(handle);
  if (found != connections_.end()) found->second.want = size_max;
}

void LoopbackNetwork::Close(NetHandle handle) {
  const auto found = connections_.find(handle);
  if (found == connections_.end()) return;
  found->second.closing = true;
  // Discards the peer's bytes from now on.  Otherwise the robot could wait for ever: a client of a
  // test may never call Poll() again, and then the bytes of the robot would fill the window.
  found->second.in().discards = true;
  found->second.in().bytes.clear();
  Push(handle, &found->second);
}

void LoopbackNetwork::Bind(NetHandle handle, uint16_t port, bool) { udps_[handle].port = port; }

void LoopbackNetwork::SendTo(NetHandle handle, NetAddress remote, const void* data, size_t size) {
  const auto sender = udps_.find(handle);
  LoopbackNetwork* const host = HostAt(remote.ip);
  if (sender == udps_.end() || host == nullptr) return;
  for (auto& [other, udp] : host->udps_) {
    if (udp.port != remote.port || udp.waiting.size() >= kDatagrams) continue;
    udp.waiting.push_back(
        {{ip_, sender->second.port}, std::string(static_cast<const char*>(data), size)});
    return;
  }
}

void LoopbackNetwork::ReceiveFrom(NetHandle handle, size_t count_max) {
  const auto found = udps_.find(handle);
  if (found != udps_.end()) found->second.want = count_max;
}

void LoopbackNetwork::Resolve(NetHandle handle, const std::string& name) {
  Add(NetworkEvent::Kind::kResolved, handle);
  const auto found = hub_->names.find(name);
  if (found != hub_->names.end()) events_.back().host = found->second;
}

void LoopbackNetwork::ResolveAddress(NetHandle handle, uint32_t ip) {
  Add(NetworkEvent::Kind::kResolved, handle);
  for (const auto& [name, host] : hub_->names) {
    const auto& addresses = host.addresses;
    if (std::find(addresses.begin(), addresses.end(), ip) == addresses.end()) continue;
    events_.back().host = host;
    return;
  }
}

void LoopbackNetwork::Drop(NetHandle handle, bool reset) {
  udps_.erase(handle);
  if (const auto listener = listeners_.find(handle); listener != listeners_.end()) {
    for (const Pending& pending : listener->second.backlog) pending.link->reset = true;
    listeners_.erase(listener);
  }
  for (auto& [number, listener] : listeners_) std::erase(listener.accepts, handle);
  if (const auto found = connections_.find(handle); found != connections_.end()) {
    Connection& connection = found->second;
    if (reset) connection.link->reset = true;
    // Passes to the peer the bytes that are not sent yet, because the kernel of a real host also
    // sends them after a program has closed the connection.
    connection.peer().bytes += connection.out;
    connection.peer().ended = true;
    connection.in().gone = true;
    connection.in().bytes.clear();
    connections_.erase(found);
  }
  std::erase_if(events_, [handle](const NetworkEvent& event) { return event.handle == handle; });
}

bool LoopbackNetwork::PollConnection(NetHandle handle, Connection* connection) {
  Push(handle, connection);
  if (connection->link->reset) {
    Add(NetworkEvent::Kind::kFailed, handle, NetError::kReset);
    return false;
  }
  Pipe& in = connection->in();
  if (connection->closing) {
    if (!in.ended || !connection->out.empty()) return true;
    Add(NetworkEvent::Kind::kClosed, handle);
    return false;
  }
  if (connection->want == 0) return true;
  if (!in.bytes.empty()) {
    const size_t count = std::min(connection->want, in.bytes.size());
    Add(NetworkEvent::Kind::kReceived, handle);
    events_.back().bytes = in.bytes.substr(0, count);
    in.bytes.erase(0, count);
    connection->want = 0;
  } else if (in.ended) {
    Add(NetworkEvent::Kind::kEnd, handle);
    connection->want = 0;
  }
  return true;
}

std::vector<NetworkEvent> LoopbackNetwork::Poll() {
  for (auto& [handle, listener] : listeners_) MatchAccepts(&listener);
  for (auto it = connections_.begin(); it != connections_.end();) {
    const auto current = it++;
    if (PollConnection(current->first, &current->second)) continue;
    current->second.peer().ended = true;
    current->second.in().gone = true;
    connections_.erase(current);
  }
  for (auto& [handle, udp] : udps_) {
    const bool any = !udp.waiting.empty();
    for (; udp.want > 0 && !udp.waiting.empty(); --udp.want) {
      Add(NetworkEvent::Kind::kDatagram, handle);
      events_.back().remote = udp.waiting.front().remote;
      events_.back().bytes = std::move(udp.waiting.front().bytes);
      udp.waiting.pop_front();
    }
    if (any) udp.want = 0;
  }
  return std::exchange(events_, {});
}

}  // namespace openr_host
