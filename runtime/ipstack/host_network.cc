#include "runtime/ipstack/host_network.h"

#include <fmt/format.h>

#include <algorithm>
#include <cerrno>
#include <cstring>

#include "runtime/base/wall_clock.h"
#include "runtime/ipstack/host_resolver.h"

namespace openr_host {

NetworkEvent NoteEvent(std::string text) {
  NetworkEvent event;
  event.kind = NetworkEvent::Kind::kNote;
  event.bytes = std::move(text);
  return event;
}

NetworkEvent FailedEvent(NetHandle handle, NetError error) {
  NetworkEvent event;
  event.kind = NetworkEvent::Kind::kFailed;
  event.handle = handle;
  event.error = error == NetError::kNone ? NetError::kFailed : error;
  return event;
}

namespace {

NetworkEvent EventOf(NetworkEvent::Kind kind, NetHandle handle) {
  NetworkEvent event;
  event.kind = kind;
  event.handle = handle;
  return event;
}

bool MustWait(int error) { return error == EAGAIN || error == EWOULDBLOCK || error == EINTR; }

}  // namespace

HostNetwork::HostNetwork(HostNetworkOptions options)
    : options_(std::move(options)),
      addresses_(options_.addresses),
      bind_ip_(options_.bind_ip),
      tcp_ports_(NetProtocol::kTcp, options_.tcp_ports),
      udp_(options_.udp_ports) {}

void HostNetwork::Attach(uint32_t ip) {
  ip_ = ip;
  // At each boot, chooses anew the host's address for server ports, and forgets the robot's
  // addresses at which sockets were bound, because the robot's address may have changed.
  bind_ip_ = addresses_.Has(ip) ? addresses_.ToHost(ip) : options_.bind_ip;
  bound_.clear();
}

bool HostNetwork::IsRobot(uint32_t ip) const {
  return ip == ip_ || ip >> 24 == 127 || bound_.contains(ip);
}

uint32_t HostNetwork::BindIp(NetHandle handle) {
  const auto at = selected_ips_.find(handle);
  if (at == selected_ips_.end()) return bind_ip_;
  const uint32_t robot = at->second;
  selected_ips_.erase(at);
  return bound_[robot] = addresses_.ToHost(robot);
}

void HostNetwork::NoteBindError(uint32_t ip, int error) {
  if (error != EADDRNOTAVAIL) return;
  events_.push_back(NoteEvent(
      fmt::format("a server port cannot be opened at {}: this computer has no such address; a "
                  "program binds to what --ip or {} says for it",
                  AddressText(ip), kAddressFile)));
}

NetAddress HostNetwork::ToHost(NetAddress remote, const HostPorts& ports) {
  const uint16_t own = ports.HostPort(remote.port);
  if (own != 0 && IsRobot(remote.ip)) {
    const auto bound = bound_.find(remote.ip);
    const uint32_t ip = bound == bound_.end() ? bind_ip_ : bound->second;
    return {ip == 0 ? 0x7f000001 : ip, own};
  }
  // If `remote` has the robot's own address, the robot does not listen on remote.port, as checked
  // above.  Returns port 0, so that the connect fails and does not reach a program of the host.
  // But if a pair of the options translates the robot's own address, uses this pair, as the user
  // has asked.
  if (remote.ip == ip_ && !addresses_.Has(ip_)) return {remote.ip, 0};
  return addresses_.ToHost(remote);
}

NetAddress HostNetwork::FromHost(NetAddress remote, const HostPorts& ports) const {
  const bool local = remote.ip == bind_ip_ || remote.ip >> 24 == 127;
  if (const uint16_t own = local ? ports.RobotPort(remote.port) : uint16_t{0}; own != 0) {
    return {ip_, own};
  }
  return addresses_.FromHost(remote);
}

void HostNetwork::Listen(NetHandle handle, uint16_t port) {
  Fd fd;
  const uint32_t ip = BindIp(handle);
  const auto try_bind = [&](uint16_t host_port) {
    fd = OpenSocket(NetProtocol::kTcp);
    return fd.valid() ? ListenOn(fd, {ip, host_port}, kBacklog) : errno;
  };
  std::string note;
  const int error = tcp_ports_.Bind(
      port, try_bind, [&] { return PortOf(fd); }, &note);
  NoteBindError(ip, error);
  if (error != 0) events_.push_back(FailedEvent(handle, NetErrorOf(error)));
  if (!note.empty()) events_.push_back(NoteEvent(note));
  if (error == 0) listeners_[handle].fd = std::move(fd);
}

void HostNetwork::Accept(NetHandle listener, NetHandle handle) {
  const auto found = listeners_.find(listener);
  if (found != listeners_.end()) found->second.accepts.push_back(handle);
}

void HostNetwork::Connect(NetHandle handle, uint16_t, NetAddress remote) {
  const NetAddress address = ToHost(remote, tcp_ports_);
  Connection connection;
  connection.fd = OpenSocket(NetProtocol::kTcp);
  int error = connection.fd.valid() ? ECONNREFUSED : errno;
  if (connection.fd.valid() && address.port != 0) error = ConnectTo(connection.fd, address);
  if (error != 0 && error != EINPROGRESS) {
    events_.push_back(FailedEvent(handle, NetErrorOf(error)));
    return;
  }
  connection.connecting = true;
  connections_[handle] = std::move(connection);
}

void HostNetwork::Send(NetHandle handle, const void* data, size_t size) {
  const auto found = connections_.find(handle);
  if (found == connections_.end() || found->second.failed) return;
  found->second.out.append(static_cast<const char*>(data), size);
  Push(handle, &found->second);
}

// Gives the bytes that wait on `connection` to the host's socket, as many as the socket accepts.
// If the program has closed the connection, ends the stream after the last byte.
void HostNetwork::Push(NetHandle handle, Connection* connection) {
  std::string& out = connection->out;
  size_t done = 0;
  while (done < out.size()) {
    const int64_t count = SendBytes(connection->fd, out.data() + done, out.size() - done);
    if (count < 0) {
      if (!MustWait(errno)) Fail(handle, connection, errno);
      break;
    }
    done += static_cast<size_t>(count);
  }
  out.erase(0, done);
  connection->accepted_bytes += done;
  if (connection->closing && out.empty() && !connection->ended) {
    EndStream(connection->fd);
    connection->ended = true;
  }
}

void HostNetwork::Fail(NetHandle handle, Connection* connection, int error) {
  if (connection->failed) return;
  connection->failed = true;
  events_.push_back(FailedEvent(handle, NetErrorOf(error)));
}

void HostNetwork::Receive(NetHandle handle, size_t size_max) {
  const auto found = connections_.find(handle);
  if (found != connections_.end()) found->second.want = size_max;
}

void HostNetwork::Close(NetHandle handle) {
  const auto found = connections_.find(handle);
  if (found == connections_.end()) return;
  found->second.closing = true;
  if (!found->second.failed) Push(handle, &found->second);
}

void HostNetwork::Bind(NetHandle handle, uint16_t port, bool any_port) {
  const uint32_t ip = BindIp(handle);
  // If the stack has chosen the port, binds the socket to 0.0.0.0, which means all addresses of the
  // host.  In this case the program is a client, which must reach other hosts; a socket bound to
  // 127.0.0.1 cannot reach them.
  NoteBindError(ip, udp_.Bind(handle, {any_port ? 0 : ip, port}, any_port, &events_));
}

void HostNetwork::SendTo(NetHandle handle, NetAddress remote, const void* data, size_t size) {
  const NetAddress address = ToHost(remote, udp_.ports());
  if (address.port != 0) udp_.SendTo(handle, address, data, size, &events_);
}

void HostNetwork::ReceiveFrom(NetHandle handle, size_t count_max) {
  udp_.ReceiveFrom(handle, count_max);
}

void HostNetwork::Resolve(NetHandle handle, const std::string& name) {
  NetworkEvent event = EventOf(NetworkEvent::Kind::kResolved, handle);
  const auto known = options_.names.find(name);
  if (known != options_.names.end()) {
    event.host = known->second;
  } else if (const NetError error = ResolveOnHost(name, &event.host); error != NetError::kNone) {
    event = FailedEvent(handle, error);
  } else {
    for (uint32_t& ip : event.host.addresses) ip = addresses_.FromHost(ip);
  }
  events_.push_back(std::move(event));
}

void HostNetwork::ResolveAddress(NetHandle handle, uint32_t ip) {
  NetworkEvent event = EventOf(NetworkEvent::Kind::kResolved, handle);
  const auto known =
      std::find_if(options_.names.begin(), options_.names.end(), [ip](const auto& entry) {
        const std::vector<uint32_t>& all = entry.second.addresses;
        return std::find(all.begin(), all.end(), ip) != all.end();
      });
  if (known != options_.names.end()) {
    event.host = known->second;
  } else if (const NetError error = ResolveAddressOnHost(addresses_.ToHost(ip), &event.host);
             error != NetError::kNone) {
    event = FailedEvent(handle, error);
  } else if (!event.host.addresses.empty()) {
    event.host.addresses.assign(1, ip);  // the address that the program has asked about
  }
  events_.push_back(std::move(event));
}

void HostNetwork::Drop(NetHandle handle, bool reset) {
  udp_.Drop(handle);
  selected_ips_.erase(handle);
  listeners_.erase(handle);
  for (auto& [number, listener] : listeners_) std::erase(listener.accepts, handle);
  if (const auto found = connections_.find(handle); found != connections_.end()) {
    if (reset) ResetOnClose(found->second.fd);
    connections_.erase(found);
  }
  std::erase_if(events_, [handle](const NetworkEvent& event) { return event.handle == handle; });
}

bool HostNetwork::IsTimeToAccept() {
  if (options_.accept_interval_ns == 0 || listeners_.empty()) return true;
  const int64_t now_ns = WallClockNs();
  if (now_ns < next_accept_ns_) return false;
  next_accept_ns_ = now_ns + options_.accept_interval_ns;
  return true;
}

void HostNetwork::AcceptAll(Listener* listener) {
  while (!listener->accepts.empty()) {
    NetAddress remote;
    Fd fd = AcceptFrom(listener->fd, &remote);
    if (!fd.valid()) {
      // Continues with the next client after ECONNABORTED, which means that a client has closed its
      // connection before it was accepted.
      if (errno == ECONNABORTED) continue;
      if (!MustWait(errno)) {
        events_.push_back(NoteEvent(fmt::format("a connection waits: {}", std::strerror(errno))));
      }
      return;
    }
    const NetHandle handle = listener->accepts.front();
    listener->accepts.pop_front();
    connections_[handle].fd = std::move(fd);
    events_.push_back(EventOf(NetworkEvent::Kind::kAccepted, handle));
    events_.back().remote = FromHost(remote, tcp_ports_);
  }
}

void HostNetwork::PollConnection(NetHandle handle, Connection* connection) {
  if (connection->failed) return;
  if (connection->connecting) {
    const int error = ConnectResult(connection->fd);
    if (error == EINPROGRESS) return;
    connection->connecting = false;
    if (error != 0) return Fail(handle, connection, error);
    events_.push_back(EventOf(NetworkEvent::Kind::kConnected, handle));
  }
  Push(handle, connection);
  if (connection->accepted_bytes > 0) {
    events_.push_back(EventOf(NetworkEvent::Kind::kSent, handle));
    events_.back().count = std::exchange(connection->accepted_bytes, 0);
  }
  if (connection->failed) return;
  if (connection->closing) {
    Discard(handle, connection);
  } else if (connection->want > 0) {
    Read(handle, connection);
  }
}

void HostNetwork::Read(NetHandle handle, Connection* connection) {
  NetworkEvent event = EventOf(NetworkEvent::Kind::kReceived, handle);
  const int64_t count =
      ReceiveBytes(connection->fd, std::min(connection->want, kReadBytesMax), &event.bytes);
  if (count < 0) {
    if (!MustWait(errno)) Fail(handle, connection, errno);
    return;
  }
  if (count == 0) event.kind = NetworkEvent::Kind::kEnd;
  connection->want = 0;
  events_.push_back(std::move(event));
}

// Reads and drops data that still arrive on a connection that the program has closed.  One call
// reads a limited number of bytes, so that a peer that never stops sending cannot hold up the run;
// the next polls read more.
void HostNetwork::Discard(NetHandle handle, Connection* connection) {
  std::string bytes;
  for (size_t total = 0; total < kReadBytesMax * 4; total += bytes.size()) {
    const int64_t count = ReceiveBytes(connection->fd, kReadBytesMax, &bytes);
    if (count < 0 && MustWait(errno)) return;
    if (count < 0) return Fail(handle, connection, errno);
    if (count > 0) continue;
    if (!connection->ended) return;  // this side still has data to send
    events_.push_back(EventOf(NetworkEvent::Kind::kClosed, handle));
    connection->failed = true;  // prevents more events for this connection
    return;
  }
}

std::vector<NetworkEvent> HostNetwork::Poll() {
  if (IsTimeToAccept()) {
    for (auto& [handle, listener] : listeners_) AcceptAll(&listener);
  }
  for (auto& [handle, connection] : connections_) PollConnection(handle, &connection);
  const size_t tcp_events = events_.size();
  udp_.Poll(&events_);
  for (size_t i = tcp_events; i < events_.size(); ++i) {
    events_[i].remote = FromHost(events_[i].remote, udp_.ports());
  }
  return std::exchange(events_, {});
}

void HostNetwork::Forget() {
  listeners_.clear();
  connections_.clear();
  udp_.Forget();
  selected_ips_.clear();
  events_.clear();
}

uint16_t HostNetwork::HostPort(NetProtocol protocol, uint16_t port) const {
  return protocol == NetProtocol::kTcp ? tcp_ports_.HostPort(port) : udp_.ports().HostPort(port);
}

}  // namespace openr_host
