// The UDP half of HostNetwork.
#pragma once

#include <cstdint>
#include <map>
#include <vector>

#include "runtime/ipstack/host_ports.h"
#include "runtime/ipstack/host_socket.h"
#include "runtime/ipstack/network.h"

namespace openr_host {

struct HostNetworkOptions;

// Addresses here are those of the host; HostNetwork translates.
class HostUdp {
 public:
  explicit HostUdp(const HostNetworkOptions& options);

  // Events of these commands are appended to `events`.
  void Bind(NetHandle handle, uint16_t port, bool any_port, std::vector<NetworkEvent>* events);
  void SendTo(NetHandle handle, NetAddress remote, const void* data, size_t size,
              std::vector<NetworkEvent>* events);
  void ReceiveFrom(NetHandle handle, size_t count_max);
  void Drop(NetHandle handle) { sockets_.erase(handle); }
  void Poll(std::vector<NetworkEvent>* events);

  const HostPorts& ports() const { return ports_; }

 private:
  struct Socket {
    Fd fd;
    size_t want = 0;  // datagrams
  };

  const uint32_t bind_ip_;
  HostPorts ports_;
  std::map<NetHandle, Socket> sockets_;
};

}  // namespace openr_host
