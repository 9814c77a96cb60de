// Stops an object for a fault that the robot's processor detects and the host's processor does not.
#pragma once

#include <string>

namespace openr_host {

// Ends the running handler as a crash of its object.  `what` names the fault: "unaligned access of
// 4 bytes".  Executes an invalid instruction, so that the process gets SIGILL while the code that
// made the fault is still on the stack.  The signal handler (openr/ending/crash_log.cc) can then
// name this code.
[[noreturn]] void StopAsTheRobotDoes(const std::string& what);

// Returns the text about the fault with which StopAsTheRobotDoes() has stopped an object, such as
// "unaligned access of 4 bytes"; "" if it was never called.  Called by the handler of SIGILL to
// describe the crash.
const char* AnnouncedFault();

}  // namespace openr_host
