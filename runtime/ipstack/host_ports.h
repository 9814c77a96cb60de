// Which port of the host stands for which port of the robot.
//
// The object keeps its number (54000); on the host that number may be taken, by another robot or
// another run, and then the next free one is taken instead, unless a port was asked for by number.
#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <string>

#include "runtime/ipstack/network.h"

namespace openr_host {

class HostPorts {
 public:
  // How many numbers above the wanted one are tried before any free port is taken.
  static constexpr int kNextPorts = 100;

  // `wished`: robot's port to host's port, which it gets or none; 0: any free one.  Ports that
  // are not in it try their own number first.
  HostPorts(NetProtocol protocol, std::map<uint16_t, uint16_t> wished)
      : protocol_(protocol), wished_(std::move(wished)) {}

  // Binds the robot's `port`: calls take(host port), which returns 0 or an errno, for the port it
  // had before, the wished one or its own number; then for the next numbers and at last for 0,
  // unless it was wished for by number.  `bound` tells the host's port after success.  Returns the
  // last errno; `note` becomes a text for the user when the expected port could not be had.
  int Bind(uint16_t port, const std::function<int(uint16_t)>& take,
           const std::function<uint16_t()>& bound, std::string* note);

  // 0: not bound yet.
  uint16_t HostPort(uint16_t port) const;

  // 0: none of ours.
  uint16_t RobotPort(uint16_t host_port) const;

 private:
  const NetProtocol protocol_;
  const std::map<uint16_t, uint16_t> wished_;
  std::map<uint16_t, uint16_t> chosen_;  // by the robot's port
};

}  // namespace openr_host
