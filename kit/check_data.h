// Finds pointers in the data that objects send with SetData(&data, sizeof data).  The receiver gets
// a copy of the bytes, in which pointers are useless, because they point to the memory of the
// sender (field-notes.md, 2.6 and 2.7).  Finds classes with virtual functions in regions, too: an
// instance of such a class has a pointer to a table in the image of the sender.
#pragma once

#include "kit/project.h"
#include "kit/remarks.h"

namespace openr_host {

// Warns if the data that an object sends contain a container, a string, a pointer or a virtual
// function.  Finds only simple calls, which name a variable or a type.  The type must be a struct
// or class of the program.
//
// Warns also if an object makes an instance of a class with virtual functions in a region, new
// (region->Base()) Shape, and sends the region, and a source of another folder calls a virtual
// function of received data of this class.  Without such a call the robot does not crash, so there
// is no warning.
void CheckSentData(const Project& project, Remarks* remarks);

}  // namespace openr_host
