// Checks the images that OBJECT.CFG of a stick names, and finds the objects of the project that
// they are made from.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "kit/check_objects.h"
#include "runtime/config/stub_config.h"

namespace openr_host {

// The object that has a certain service.
struct ServiceOwner {
  std::string name;
  // The only robot design in OBJECT.CFG that loads the object; "" means that all designs do.
  std::string section;
};

struct StickImages {
  std::multimap<std::string, ServiceOwner> services;  // by full name of the service
  std::vector<StubService> declared;  // from the stub.cfg files of objects on the stick
  bool has_gateway = false;           // OBJECT.CFG names the gateway
  bool knows_all = true;              // false: the services of some image are not known
};

// Adds remarks about images that are missing and that no build makes, that cannot be loaded, or
// that share a name with another one.
StickImages CheckImages(const StickFolder& stick, const Project& project, const ObjectParts& parts,
                        Remarks* remarks);

}  // namespace openr_host
