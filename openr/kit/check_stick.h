// A Memory Stick as it will be read at boot.
#pragma once

#include "openr/kit/check.h"
#include "openr/kit/object_parts.h"
#include "openr/kit/project.h"

namespace openr_host {

// `project`: where objects may come from that are not built yet; perhaps without any.
void CheckStick(const StickFolder& stick, const Project& project, const ObjectParts& parts,
                Remarks* remarks);

}  // namespace openr_host
