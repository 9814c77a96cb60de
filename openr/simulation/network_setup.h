// Makes the network of a robot.
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "runtime/config/address_config.h"

namespace openr_host {

class IpStack;
class Network;

// Returns a network of sockets on the loopback interface.  `rc_port` is the port of the host for
// the remote control; 0: any free port; -1: the robot's own port or, if that is taken, the next
// free one.  `addresses` maps addresses that programs have compiled in to addresses of the host.
std::unique_ptr<Network> MakeHostNetwork(int rc_port, std::vector<AddressPair> addresses);

// Returns the reason why no program can listen on `rc_port` now, or "".
std::string WhyNoPort(int rc_port);

// Returns a network without sockets, in which the robot is alone.
std::unique_ptr<Network> MakeLonelyNetwork();

// Returns the port of the host for the remote control; 0 while no object listens.
uint16_t HostPortOfRemoteControl(const IpStack& network);

}  // namespace openr_host
