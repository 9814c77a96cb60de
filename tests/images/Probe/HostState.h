// Calls of functions of the C and C++ libraries that would show the state of the host.
#ifndef HostState_h_DEFINED
#define HostState_h_DEFINED

#include <string>

// The answer to `command`; empty when it is not about the state of the host.
std::string AnswerHostState(const std::string& command);

#endif  // HostState_h_DEFINED
