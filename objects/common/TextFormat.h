//
// TextFormat(): formats a text as printf() does, and returns it as a std::string.
//

#ifndef TextFormat_h_DEFINED
#define TextFormat_h_DEFINED

#include <string>

// Returns the formatted text, cut off after 239 characters like a line of the robot's log
// (Programmer's Guide 5.1).  The limit is low, because the buffer is on the stack, which is small.
std::string TextFormat(const char* format, ...) __attribute__((format(printf, 1, 2)));

#endif  // TextFormat_h_DEFINED
