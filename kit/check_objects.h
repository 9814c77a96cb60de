// Objects as they lie in their folders: stub.cfg, .ocf, sources.
#pragma once

#include <string>
#include <vector>

#include "kit/check.h"
#include "kit/object_parts.h"
#include "kit/project.h"
#include "runtime/config/stub_config.h"

namespace openr_host {

void CheckObjects(const Project& project, const ObjectParts& parts, Remarks* remarks);

// An object of the project that a stick loads.
struct PlacedObject {
  const ObjectFolder* folder = nullptr;
  std::string section;  // of OBJECT.CFG: the only robot design that loads it; "" for every one
};

// Names in .ocf files that two objects have in common which one robot loads.
void CheckObjectNames(const std::vector<PlacedObject>& placed, const ObjectParts& parts,
                      Remarks* remarks);

// Whether a service is one of those that an object only has because it must have one: nothing is
// ever connected to it.
bool IsDummy(const StubService& service);

// Names of Memory Stick files in the text of a source that the robot cannot open.
void CheckStickPaths(const std::string& file, const std::string& text, Remarks* remarks);

}  // namespace openr_host
