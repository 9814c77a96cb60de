//
// printf into a std::string.
//

#ifndef TextFormat_h_DEFINED
#define TextFormat_h_DEFINED

#include <string>

// The result has at most 239 characters, as a line of the robot's log has (Programmer's Guide 5.1).
// The buffer is on the stack, which is small.
std::string TextFormat(const char* format, ...) __attribute__((format(printf, 1, 2)));

#endif  // TextFormat_h_DEFINED
