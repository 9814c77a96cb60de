// Checks the folders of objects: stub.cfg, .ocf file, sources.
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
  // The only robot design in OBJECT.CFG that loads the object; "" means that all designs do.
  std::string section;
};

// Adds a remark for each name in .ocf files that two objects of one robot share.
void CheckObjectNames(const std::vector<PlacedObject>& placed, const ObjectParts& parts,
                      Remarks* remarks);

// Returns whether the service is a dummy, to which nothing is connected.  Objects declare dummies
// because stub.cfg must have at least one subject and one observer.
bool IsDummy(const StubService& service);

// Adds a remark for each file name in the text of a source that the robot cannot open.
void CheckStickPaths(const std::string& file, const std::string& text, Remarks* remarks);

}  // namespace openr_host
