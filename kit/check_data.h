// Finds pointers in the data that objects send with SetData(&data, sizeof data).  The receiver gets
// a copy of the bytes, in which pointers are useless, because they point to the memory of the
// sender (field-notes.md, 2.6 and 2.7).
#pragma once

#include "kit/check.h"
#include "kit/project.h"

namespace openr_host {

// Warns if the data that an object sends contain a container, a string, a pointer or a virtual
// function.  Finds only simple calls, which name a variable or a type.  The type must be a struct
// or class of the program.
void CheckSentData(const Project& project, Remarks* remarks);

}  // namespace openr_host
