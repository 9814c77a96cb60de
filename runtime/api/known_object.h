// IsKnown(): checks an object id that a program gives to a function of MCOOP.h.
#pragma once

#include "runtime/core/system.h"

namespace openr_host {

// Returns whether an object has this id.  While the constructors of an image run for the first
// time, their object is not in the object table yet.  So the id of the current object counts as
// known, too (core.md, 10.1: an OID is valid in static constructors).
inline bool IsKnown(ObjectId id) {
  return id == t_current.object->id || t_current.system->object(id) != nullptr;
}

}  // namespace openr_host
