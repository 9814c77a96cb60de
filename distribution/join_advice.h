// Makes the command line with which a user starts a worker on another host (openr join).
#pragma once

#include <string>

#include "distribution/bus.h"

namespace openr_host {

// Returns "start it on HOST with: openr join --process vision ...", with every flag whose value
// differs from the default of openr join.  `bus` are the options of the run, `host` is the address
// of the worker's host.
std::string JoinAdvice(const std::string& process, const std::string& host, const BusOptions& bus);

}  // namespace openr_host
