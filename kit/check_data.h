// What objects send with SetData(&data, sizeof data): bytes, of which pointers mean nothing to the
// receiver (field-notes.md, 2.6 and 2.7).
#pragma once

#include "kit/check.h"
#include "kit/project.h"

namespace openr_host {

// Sees the plain cases only: a struct or class of the program, a variable or type named in the
// call, a member that is a container, a string or a pointer, or a virtual function.
void CheckSentData(const Project& project, Remarks* remarks);

}  // namespace openr_host
