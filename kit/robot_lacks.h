// Functions that programs on a PC call and that the robot does not have, such as fork() and
// sleep().
#pragma once

#include <string_view>

namespace openr_host {

struct LackedCall {
  bool is_error;    // true: the call fails on this host too
  const char* why;  // text that follows "NAME(): "
};

// Returns the error or warning about a call of the function `name`, if the robot lacks this
// function; null if the robot has the function, or if the name is not known.
const LackedCall* FindLackedCall(std::string_view name);

// Returns whether the first argument of the function `name` is the name of a file or folder.
bool TakesFileName(std::string_view name);

}  // namespace openr_host
