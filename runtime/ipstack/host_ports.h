// Maps ports of the robot to ports of the host.
//
// A port keeps its number (54000) if that is free on the host.  If another robot or another run has
// taken it, the next free number is used, unless the user asked for a certain number.
#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <string>

#include "runtime/ipstack/network.h"

namespace openr_host {

class HostPorts {
 public:
  // Number of ports above the wanted one that are tried before any free port is taken.
  static constexpr int kNextPorts = 100;

  // `wished`: robot's port -> host's port that it must get; 0: any free one.  Ports without an
  // entry try their own number first.
  HostPorts(NetProtocol protocol, std::map<uint16_t, uint16_t> wished)
      : protocol_(protocol), wished_(std::move(wished)) {}

  // Binds the robot's `port` and returns 0 or an errno.  Bind() calls take(host port), which also
  // returns 0 or an errno, until it succeeds: first with the port of an earlier call, the wished
  // port or the port's own number, then with the next numbers, finally with 0.  If a certain number
  // is wished, Bind() tries no other.  After success `bound` must return the host's port.  `note`
  // becomes a text for the user if the expected port was in use.
  int Bind(uint16_t port, const std::function<int(uint16_t)>& take,
           const std::function<uint16_t()>& bound, std::string* note);

  // Returns the host's port for the robot's `port`; 0: not bound yet.
  uint16_t HostPort(uint16_t port) const;

  // Returns the robot's port that has the host's port `host_port`; 0: none.
  uint16_t RobotPort(uint16_t host_port) const;

 private:
  const NetProtocol protocol_;
  const std::map<uint16_t, uint16_t> wished_;
  std::map<uint16_t, uint16_t> chosen_;  // robot's port -> host's port
};

}  // namespace openr_host
