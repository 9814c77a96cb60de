// Checks the configuration files of a Memory Stick, which the robot reads at boot.
#pragma once

#include "kit/check.h"
#include "kit/object_parts.h"
#include "kit/project.h"

namespace openr_host {

// Checks the configuration files of `stick`.  If an image is not built yet, takes the image's
// services from the sources of its object in `project`.  `project` may have no objects.
void CheckStick(const StickFolder& stick, const Project& project, const ObjectParts& parts,
                CheckTarget target, Remarks* remarks);

}  // namespace openr_host
