//
// printf into a std::string.
//

#ifndef TextFormat_h_DEFINED
#define TextFormat_h_DEFINED

#include <string>

// At most 239 characters come out: the robot's log line ends there too (Programmer's
// Guide 5.1), and the buffer lies on a small stack.
std::string TextFormat(const char* format, ...) __attribute__((format(printf, 1, 2)));

#endif  // TextFormat_h_DEFINED
