// The network of a robot.
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "runtime/config/address_config.h"

namespace openr_host {

class IpStack;
class Network;

// Sockets on the loopback interface.  `rc_port`: the port of the host for the remote control; 0:
// any free one, -1: the robot's own if it is free, else the next free one.  `addresses`: those that
// programs have compiled in, and where they are.
std::unique_ptr<Network> MakeHostNetwork(int rc_port, std::vector<AddressPair> addresses);

// Why nobody can listen on `rc_port` now, or "".
std::string WhyNoPort(int rc_port);

// Without sockets and without anybody else in it.
std::unique_ptr<Network> MakeLonelyNetwork();

// 0 while nobody listens.
uint16_t HostPortOfRemoteControl(const IpStack& network);

}  // namespace openr_host
