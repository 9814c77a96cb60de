// The UDP part of HostNetwork.
#pragma once

#include <cstdint>
#include <map>
#include <utility>
#include <vector>

#include "runtime/ipstack/host_ports.h"
#include "runtime/ipstack/host_socket.h"
#include "runtime/ipstack/network.h"

namespace openr_host {

// Addresses of this class are those of the host; HostNetwork translates them.
class HostUdp {
 public:
  // `ports`: robot's port -> host's port, see HostPorts.
  explicit HostUdp(std::map<uint16_t, uint16_t> ports)
      : ports_(NetProtocol::kUdp, std::move(ports)) {}

  // All commands append their events to `events`.  `local` has an address of the host and a port of
  // the robot.  Returns 0 or an errno.
  int Bind(NetHandle handle, NetAddress local, bool any_port, std::vector<NetworkEvent>* events);
  void SendTo(NetHandle handle, NetAddress remote, const void* data, size_t size,
              std::vector<NetworkEvent>* events);
  void ReceiveFrom(NetHandle handle, size_t count_max);
  void Drop(NetHandle handle) { sockets_.erase(handle); }
  void Poll(std::vector<NetworkEvent>* events);

  const HostPorts& ports() const { return ports_; }

 private:
  struct Socket {
    Fd fd;
    size_t want = 0;  // limit of the pending ReceiveFrom(); 0: none is pending
  };

  HostPorts ports_;
  std::map<NetHandle, Socket> sockets_;
};

}  // namespace openr_host
