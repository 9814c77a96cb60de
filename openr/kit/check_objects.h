// Objects as they lie in their folders: stub.cfg, .ocf, sources.
#pragma once

#include "openr/kit/check.h"
#include "openr/kit/project.h"
#include "runtime/config/stub_config.h"

namespace openr_host {

void CheckObjects(const Project& project, Remarks* remarks);

// Whether a service is one of those that an object only has because it must have one: nothing is
// ever connected to it.
bool IsDummy(const StubService& service);

// Names of Memory Stick files in the text of a source that the robot cannot open.
void CheckStickPaths(const std::string& file, const std::string& text, Remarks* remarks);

}  // namespace openr_host
