// Maps ports of the robot to ports of the host.
//
// A port of the robot keeps its number, such as 54000, if that number is free on the host.  If
// another robot or another run uses that number, the next free number is taken.  If the user asked
// for a certain number, no other number is taken.
#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <string>

#include "runtime/ipstack/network.h"

namespace openr_host {

class HostPorts {
 public:
  // The number of port numbers above the wanted port that are tried if the wanted port is in use on
  // the host.  If these ports are in use, too, any free port is taken.
  static constexpr int kNextPorts = 100;

  // `wished` has the ports that the user asked for: the key is a port of the robot, the value is
  // its port on the host (0: any free port).  A port without an entry keeps its number if that
  // number is free.
  HostPorts(NetProtocol protocol, std::map<uint16_t, uint16_t> wished)
      : protocol_(protocol), wished_(std::move(wished)) {}

  // Finds a port of the host for the robot's `port` and returns 0 or an errno.  Each call of
  // try_bind(host port) tries to bind a socket and returns 0 or an errno.  Calls try_bind() for
  // these ports until a call returns 0:
  //   1. the host's port of an earlier Bind() of `port`, else the port that the user asked for
  //      (a value of `wished`), else `port` itself;
  //   2. if that port is in use, the kNextPorts numbers above `port`;
  //   3. 0, for any free port.
  // If the user asked for a certain port, only step 1 is done.  bound() returns the port of the
  // socket that try_bind() has bound.  If step 1 fails, sets `note` to a text for the user, unless
  // steps 2 and 3 have failed too.
  int Bind(uint16_t port, const std::function<int(uint16_t)>& try_bind,
           const std::function<uint16_t()>& bound, std::string* note);

  // Returns the host's port for the robot's `port`, or 0 if `port` is not bound yet.
  uint16_t HostPort(uint16_t port) const;

  // Returns the robot's port that is bound to the host's port `host_port`, or 0 if no port of the
  // robot is bound to it.
  uint16_t RobotPort(uint16_t host_port) const;

 private:
  const NetProtocol protocol_;
  const std::map<uint16_t, uint16_t> wished_;
  // The ports that Bind() has bound.  The key is a port of the robot, the value its port on the
  // host.
  std::map<uint16_t, uint16_t> chosen_;
};

}  // namespace openr_host
