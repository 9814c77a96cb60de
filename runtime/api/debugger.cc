// A function that debuggers call while an object stands still in a handler.
#include <OPENR/OPENR.h>

#include "runtime/core/current.h"
#include "runtime/core/robot_services.h"
#include "runtime/core/system.h"

using openr_host::t_current;

// Returns the locator of the primitive `id`, such as "PRM:/r1/c1-Joint2:j1", on the robot of the
// running object.  Returns null if the locator is not known, and while no object runs.  Allocates
// nothing, because the debugger may have stopped the object in the middle of malloc().
// tools/gdb/openr_printers.py calls this function.
extern "C" [[gnu::visibility("default"), gnu::used]] const char* openr_locator_of(OPrimitiveID id) {
  if (t_current.object == nullptr) return nullptr;
  return t_current.system->robot(t_current.object->robot).services->LocatorOf(id);
}
