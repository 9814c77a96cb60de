// Faults that stop the robot's processor and not the host's.
#pragma once

#include <string>

namespace openr_host {

// Ends the handler that runs as a crash of its object, the way the robot would: "unaligned access
// of 4 bytes".  The process gets SIGILL, on top of the code that made the fault.
[[noreturn]] void StopAsTheRobotDoes(const std::string& what);

// The text that StopAsTheRobotDoes() was called with; "" when it was not called.  For the signal
// handler.
const char* AnnouncedFault();

}  // namespace openr_host
