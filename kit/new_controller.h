// openr controller new: a controller to begin with.
#pragma once

#include <string>
#include <vector>

#include "kit/new_object.h"

namespace openr_host {

// Why `name` cannot be the name of a controller, which is that of its C file, or "".
std::string WhyNoControllerName(const std::string& name);

// NAME.c, Makefile.sources, Makefile.openr; to be written by WriteNewObject().
std::vector<NewFile> MakeNewController(const std::string& name);

}  // namespace openr_host
