#include "runtime/ipstack/host_udp.h"

#include <fmt/format.h>

#include <cerrno>
#include <cstring>

#include "runtime/ipstack/host_network.h"

namespace openr_host {
namespace {

constexpr size_t kDatagramMax = 65536;  // larger than any IPv4 datagram

}  // namespace

int HostUdp::Bind(NetHandle handle, NetAddress local, bool any_port,
                  std::vector<NetworkEvent>* events) {
  Fd fd;
  const auto try_bind = [&](uint16_t host_port) {
    fd = OpenSocket(NetProtocol::kUdp);
    if (!fd.valid()) return errno;
    return BindSocket(fd, {local.ip, any_port ? uint16_t{0} : host_port});
  };
  std::string note;
  const int error = ports_.Bind(
      local.port, try_bind, [&] { return PortOf(fd); }, &note);
  if (error != 0) events->push_back(FailedEvent(handle, NetErrorOf(error)));
  if (!note.empty()) events->push_back(NoteEvent(note));
  if (error == 0) sockets_[handle].fd = std::move(fd);
  return error;
}

void HostUdp::SendTo(NetHandle handle, NetAddress remote, const void* data, size_t size,
                     std::vector<NetworkEvent>* events) {
  const auto found = sockets_.find(handle);
  if (found == sockets_.end()) return;
  if (SendDatagram(found->second.fd, remote, data, size) >= 0 || errno == EAGAIN) return;
  const std::string why = std::strerror(errno);
  events->push_back(NoteEvent(
      fmt::format("a UDP datagram to {}.{}.{}.{}:{} was not sent: {}", remote.ip >> 24,
                  remote.ip >> 16 & 255, remote.ip >> 8 & 255, remote.ip & 255, remote.port, why)));
}

void HostUdp::ReceiveFrom(NetHandle handle, size_t count_max) {
  const auto found = sockets_.find(handle);
  if (found != sockets_.end()) found->second.want = count_max;
}

void HostUdp::Poll(std::vector<NetworkEvent>* events) {
  for (auto& [handle, socket] : sockets_) {
    bool any = false;
    for (; socket.want > 0; --socket.want) {
      NetworkEvent event;
      event.kind = NetworkEvent::Kind::kDatagram;
      event.handle = handle;
      // Stops at an error, which usually means that no datagram waits.  No error is reported: any
      // other error belongs to an earlier send (port unreachable), and UDP may lose a datagram
      // without an error.
      if (ReceiveBytes(socket.fd, kDatagramMax, &event.bytes, &event.remote) < 0) break;
      any = true;
      events->push_back(std::move(event));
    }
    // Ends the request that ReceiveFrom() has made for this UDP socket as soon as any datagrams
    // have arrived, even if the request allows more.
    if (any) socket.want = 0;
  }
}

}  // namespace openr_host
