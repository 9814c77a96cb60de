// A Memory Stick as it will be read at boot.
#pragma once

#include "kit/check.h"
#include "kit/object_parts.h"
#include "kit/project.h"

namespace openr_host {

// `project`: where objects may come from that are not built yet; perhaps without any.
void CheckStick(const StickFolder& stick, const Project& project, const ObjectParts& parts,
                Remarks* remarks);

}  // namespace openr_host
