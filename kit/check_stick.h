// Checks the configuration of a Memory Stick, read as the robot reads it at boot.
#pragma once

#include "kit/check.h"
#include "kit/object_parts.h"
#include "kit/project.h"

namespace openr_host {

// Checks `stick`.  Objects that are not built yet are looked for in `project`, which may have none.
void CheckStick(const StickFolder& stick, const Project& project, const ObjectParts& parts,
                Remarks* remarks);

}  // namespace openr_host
