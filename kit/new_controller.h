// The command `openr controller new`: makes the files of a new controller.
#pragma once

#include <string>
#include <vector>

#include "kit/new_object.h"

namespace openr_host {

// Returns the reason why `name` cannot be the name of a controller and its C file; "" if it can.
std::string ControllerNameProblem(const std::string& name);

// Returns the files of a new controller: NAME.c, Makefile.sources and Makefile.openr.
// WriteNewObject() can write them.
std::vector<NewFile> MakeNewController(const std::string& name);

}  // namespace openr_host
