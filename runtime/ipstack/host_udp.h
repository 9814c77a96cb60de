// The UDP part of HostNetwork, which connects the robot's network to sockets of the host.
#pragma once

#include <cstdint>
#include <map>
#include <utility>
#include <vector>

#include "runtime/ipstack/host_ports.h"
#include "runtime/ipstack/host_socket.h"
#include "runtime/ipstack/network.h"

namespace openr_host {

// The UDP sockets of the host.  Addresses in this class are addresses of the host; HostNetwork
// translates them.
class HostUdp {
 public:
  // `ports` has the ports of the robot for which the user wants a certain port of the host; see the
  // constructor of HostPorts.
  explicit HostUdp(std::map<uint16_t, uint16_t> ports)
      : ports_(NetProtocol::kUdp, std::move(ports)) {}

  // Opens a socket and binds it to `local`, which has an address of the host and a port of the
  // robot.  If `any_port` is true, the port gets any free number on the host.  Returns 0 or an
  // errno.  Appends the events of the command to `events`, as all commands of this class do.
  int Bind(NetHandle handle, NetAddress local, bool any_port, std::vector<NetworkEvent>* events);
  void SendTo(NetHandle handle, NetAddress remote, const void* data, size_t size,
              std::vector<NetworkEvent>* events);
  void ReceiveFrom(NetHandle handle, size_t count_max);
  void Drop(NetHandle handle) { sockets_.erase(handle); }
  void Forget() { sockets_.clear(); }
  void Poll(std::vector<NetworkEvent>* events);

  const HostPorts& ports() const { return ports_; }

 private:
  struct Socket {
    Fd fd;
    // The largest number of datagrams that the pending ReceiveFrom() of this UDP socket may return;
    // 0 if no ReceiveFrom() is pending.
    size_t want = 0;
  };

  HostPorts ports_;
  std::map<NetHandle, Socket> sockets_;
};

}  // namespace openr_host
