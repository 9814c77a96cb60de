// Addresses of the remote controls that pages use, both for robots of a run and for all other
// robots.
#pragma once

#include <string>
#include <vector>

#include "openr/live/live_folder.h"
#include "openr/remote/address.h"

namespace openr_host {

namespace remote = openr::remote;

// Returns the address in `text`, which has the form "HOST:PORT" and comes from a page.  Throws
// std::runtime_error if `text` is no address.
remote::Address ParseEndpoint(const std::string& text);

// Asks `run` for the ports of the remote control, one port for each robot.  A port is 0 if the
// robot does not listen yet.  Throws std::runtime_error if the run does not answer.
std::vector<int> RemotePorts(const LiveRun& run);

// Returns the address of the remote control of the robot number `robot` of `run`.
remote::Address AddressInRun(const LiveRun& run, size_t robot);

// Throws std::runtime_error if `address` is the address of a robot of `run`.
void RefuseOwnRobots(const LiveRun& run, const remote::Address& address);

}  // namespace openr_host
