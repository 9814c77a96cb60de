// Addresses of remote controls that pages use: of robots of a run, and of any other robot.
#pragma once

#include <string>
#include <vector>

#include "openr/live/live_folder.h"
#include "openr/remote/address.h"

namespace openr_host {

namespace remote = openr::remote;

// Returns the address "HOST:PORT" that a page has sent.  Throws std::runtime_error if it is none.
remote::Address ParseEndpoint(const std::string& text);

// Asks `run` for the ports of the remote control, one for each robot; 0: none yet.  Throws
// std::runtime_error if the run does not answer.
std::vector<int> RemotePorts(const LiveRun& run);

// Returns the address of the remote control of a robot of `run`.
remote::Address AddressInRun(const LiveRun& run, size_t robot);

// Throws std::runtime_error if `address` is that of a robot of `run`.
void CheckElsewhere(const LiveRun& run, const remote::Address& address);

}  // namespace openr_host
