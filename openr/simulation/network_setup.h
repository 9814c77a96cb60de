// Makes the network of a robot.  It uses sockets of this computer, or reaches nothing outside the
// simulation.
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "runtime/config/address_config.h"

namespace openr_host {

class IpStack;
class Network;

// Returns a network that uses sockets of this computer.  `rc_port` is the port for the remote
// control; 0: any free port; -1: the robot's own port or, if that is taken, the next free port.
// Each pair in `addresses` has an address that the robot's programs use, and the address that this
// computer uses instead.
std::unique_ptr<Network> MakeHostNetwork(int rc_port, std::vector<AddressPair> addresses);

// Returns the reason why the remote control cannot listen on the port `rc_port` of this computer;
// "" if it can listen.
std::string PortProblem(int rc_port);

// Returns a network without sockets, so that other programs cannot reach the robot.
std::unique_ptr<Network> MakeIsolatedNetwork();

// Returns the port of this computer on which the robot's remote control listens; 0 while no object
// listens.
uint16_t HostPortOfRemoteControl(const IpStack& network);

}  // namespace openr_host
