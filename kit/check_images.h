// Checks the images (.BIN files) that OBJECT.CFG of a stick names, and finds the objects of the
// project that these images are made from.
#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "kit/check_objects.h"
#include "runtime/config/stub_config.h"

namespace openr_host {

// The object that has a service, which is an end of a connection in CONNECT.CFG.
struct ServiceOwner {
  std::string name;
  // The section of OBJECT.CFG that loads the object.  A section is for one design of robot, such as
  // ERS-210; "" means that robots of all designs load the object.
  std::string section;
};

// An object of the project and the image on the stick that was built from it.
struct BuiltObject {
  const ObjectFolder* folder = nullptr;
  std::filesystem::path image;
};

struct StickImages {
  // The object that has each service; the key is the full name of the service.
  std::multimap<std::string, ServiceOwner> services;
  std::vector<StubService> declared;  // services in stub.cfg files of objects on the stick
  std::vector<BuiltObject> built;     // the images that the host can load
  bool has_gateway = false;           // true: OBJECT.CFG names the image of the TCP gateway
  bool knows_all = true;              // false: some image is missing, so its services are unknown
};

// Adds a remark (an error or a note) for each faulty image.  An image is faulty if it is missing
// and no build will make it, if `target` cannot load it, or if its object has the same name as
// another object.  Returns the services of all images.
StickImages CheckImages(const StickFolder& stick, const Project& project, const ObjectParts& parts,
                        CheckTarget target, Remarks* remarks);

}  // namespace openr_host
