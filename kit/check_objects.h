// Checks the folders of objects: stub.cfg, .ocf file, sources.
#pragma once

#include <string>
#include <vector>

#include "kit/object_parts.h"
#include "kit/project.h"
#include "kit/remarks.h"
#include "runtime/config/stub_config.h"

namespace openr_host {

void CheckObjects(const Project& project, const ObjectParts& parts, Remarks* remarks);

// An object of the project whose image is on a stick.
struct PlacedObject {
  const ObjectFolder* folder = nullptr;
  // The section of OBJECT.CFG that loads the object.  A section is for one design of robot, such as
  // ERS-210; "" means that robots of all designs load the object.
  std::string section;
};

// Adds a warning for each object that has, in its .ocf file, the same name as another object, if
// one robot loads both objects.
void CheckObjectNames(const std::vector<PlacedObject>& placed, const ObjectParts& parts,
                      Remarks* remarks);

// Returns whether the service is a dummy, to which nothing is connected.  Objects declare dummies
// because stub.cfg must have at least one subject and one observer.
bool IsDummy(const StubService& service);

// Adds a remark for each path on the stick ("/MS/...") in the source `text` that is not made of 8.3
// names.  An 8.3 name has up to 8 characters, a dot and up to 3 characters.  The robot cannot open
// files with longer names.
void CheckStickPaths(const std::string& file, const std::string& text, Remarks* remarks);

}  // namespace openr_host
