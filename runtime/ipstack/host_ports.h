// Maps ports of the robot to ports of the host.
//
// A port keeps its number (54000) if that number is free on the host.  If another robot or another
// run has taken it, the next free number is used, unless the user asked for a certain number.
#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <string>

#include "runtime/ipstack/network.h"

namespace openr_host {

class HostPorts {
 public:
  // The number of ports above the wanted port that are tried before any free port is taken.
  static constexpr int kNextPorts = 100;

  // `wished` maps a robot's port to the host's port that it must get; 0: any free port.  For ports
  // without an entry, their own number is tried first.
  HostPorts(NetProtocol protocol, std::map<uint16_t, uint16_t> wished)
      : protocol_(protocol), wished_(std::move(wished)) {}

  // Binds the robot's `port` and returns 0 or an errno.  Calls take(host port), which also returns
  // 0 or an errno, until it succeeds: first with the host's port that an earlier Bind() has found,
  // the wished port or the port's own number, then with the next numbers, finally with 0.  If
  // `wished` has a certain number, tries no other number.  After success `bound` must return the
  // host's port.  If the expected port was in use, sets `note` to a text for the user.
  int Bind(uint16_t port, const std::function<int(uint16_t)>& take,
           const std::function<uint16_t()>& bound, std::string* note);

  // Returns the host's port for the robot's `port`, or 0 if it is not bound yet.
  uint16_t HostPort(uint16_t port) const;

  // Returns the robot's port that is bound to the host's port `host_port`, or 0 if there is none.
  uint16_t RobotPort(uint16_t host_port) const;

 private:
  const NetProtocol protocol_;
  const std::map<uint16_t, uint16_t> wished_;
  std::map<uint16_t, uint16_t> chosen_;  // key: robot's port, value: host's port
};

}  // namespace openr_host
