// The images that OBJECT.CFG of a stick names, and the objects of the project that they are or
// will be.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "kit/check_objects.h"
#include "runtime/config/stub_config.h"

namespace openr_host {

// The object that has a service.
struct ServiceOwner {
  std::string name;
  std::string section;  // of OBJECT.CFG: the only robot design that loads it; "" for every one
};

struct StickImages {
  std::multimap<std::string, ServiceOwner> services;  // by full name
  std::vector<StubService> declared;  // in stub.cfg files of objects that the stick loads
  bool has_gateway = false;           // OBJECT.CFG names it
  bool knows_all = true;              // false: the services of some image are not known
};

// Remarks on images that are missing and that no build makes, that cannot be loaded, or that have
// a name in common.
StickImages CheckImages(const StickFolder& stick, const Project& project, const ObjectParts& parts,
                        Remarks* remarks);

}  // namespace openr_host
