// A Memory Stick as it will be read at boot.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "openr/kit/check.h"
#include "openr/kit/project.h"

namespace openr_host {

// `project`: where objects may come from that are not built yet; perhaps without any.
void CheckStick(const StickFolder& stick, const Project& project, Remarks* remarks);

// The names of services among the texts of an image, of whatever machine.
std::vector<std::string> ServicesInImage(std::string_view bytes);

}  // namespace openr_host
