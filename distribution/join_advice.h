// How a process that somebody else starts is started.
#pragma once

#include <string>

#include "distribution/bus.h"

namespace openr_host {

// "start it on HOST with: openr join --process vision ...", with all that differs from what openr
// join assumes.  `bus`: of the run; `host`: address of the process.
std::string JoinAdvice(const std::string& process, const std::string& host, const BusOptions& bus);

}  // namespace openr_host
