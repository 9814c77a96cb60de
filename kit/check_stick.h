// Checks the configuration files of a Memory Stick, which the robot reads at boot.
#pragma once

#include "kit/check.h"
#include "kit/object_parts.h"
#include "kit/project.h"

namespace openr_host {

// Checks `stick`.  If an image is not built yet, its services are taken from the sources of its
// object in `project`.  A project without objects is allowed.
void CheckStick(const StickFolder& stick, const Project& project, const ObjectParts& parts,
                CheckTarget target, Remarks* remarks);

}  // namespace openr_host
