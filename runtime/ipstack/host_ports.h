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

  // Binds the robot's `port`.  It calls take(host port), which returns 0 or an errno, first for the
  // port of an earlier call, the wished port or its own number, then for the next numbers, and
  // finally for 0.  A port wished for by number is tried alone.  After success `bound` returns the
  // host's port.  Returns the last errno; `note` becomes a text for the user if the expected port
  // was taken.
  int Bind(uint16_t port, const std::function<int(uint16_t)>& take,
           const std::function<uint16_t()>& bound, std::string* note);

  // 0: not bound yet.
  uint16_t HostPort(uint16_t port) const;

  // 0: not a port of this table.
  uint16_t RobotPort(uint16_t host_port) const;

 private:
  const NetProtocol protocol_;
  const std::map<uint16_t, uint16_t> wished_;
  std::map<uint16_t, uint16_t> chosen_;  // robot's port -> host's port
};

}  // namespace openr_host
