// Finds the open file of a descriptor that an object passes to a function of the C library.
#pragma once

#include <unistd.h>

#include "runtime/core/current.h"
#include "runtime/core/object.h"
#include "runtime/core/system.h"

namespace openr_host {

// Returns whether `descriptor` is the robot's console: the descriptors 0, 1 and 2 are the same
// terminal.
inline bool IsConsole(int descriptor) {
  return descriptor >= STDIN_FILENO && descriptor <= STDERR_FILENO;
}

// Calls `visit` for objects of the current object's robot until it returns true for one of them,
// and returns whether it has.  Begins with the current object, because an object whose constructors
// run is not in the table of objects yet.
template <typename Visit>
bool AnyObjectOfRobot(const Visit& visit) {
  Object* const self = t_current.object;
  if (visit(self)) return true;
  for (const auto& object : t_current.system->objects()) {
    if (object != nullptr && object.get() != self && object->robot == self->robot &&
        visit(object.get()))
      return true;
  }
  return false;
}

// Returns the file of the stick that `descriptor` refers to; null if no object of the current
// object's robot has it open.  Searches all objects, because descriptors of the robot are global:
// an object can use a descriptor that another object has opened.
OpenFiles::File* FindOpenFile(int descriptor);

// Returns whether `function`, which an object has called, must fail because `descriptor` belongs to
// no open file of the stick.  It may be a file of the run, such as its recording.  If so, adds a
// finding and sets errno to EBADF.  The descriptors of the console are not refused, and neither is
// the result -1 of a failed open(), because with it the C library's function fails anyway.
bool RefusesDescriptor(const char* function, int descriptor);

}  // namespace openr_host
