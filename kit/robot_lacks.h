// What programs for a PC call and the robot has not.
#pragma once

#include <string_view>

namespace openr_host {

struct LackedCall {
  bool is_error;    // it does not work here either
  const char* why;  // a sentence that goes on after "NAME(): "
};

// nullptr: the robot has it, or nobody knows of it.
const LackedCall* FindLackedCall(std::string_view name);

// Whether the first argument of `name` is the name of a file or folder.
bool TakesFileName(std::string_view name);

}  // namespace openr_host
