// The network of a robot.
#pragma once

#include <cstdint>

namespace openr_host {

class IpStack;
class System;

// Gives `robot` an IPStack on loopback sockets.  `rc_port`: the port of the host for the
// remote control; 0: any free one, -1: the robot's own if it is free, else any.
IpStack* AddHostNetwork(System* system, int robot, int rc_port);

// The same without sockets and without anybody else in it.
IpStack* AddLonelyNetwork(System* system, int robot);

// 0 while nobody listens.
uint16_t HostPortOfRemoteControl(const IpStack& network);

}  // namespace openr_host
