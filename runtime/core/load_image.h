// Loads images, the files with the code of objects, from the Memory Stick of a robot.
#pragma once

#include <memory>
#include <string>

#include "runtime/core/message.h"

namespace openr_host {

class ImageObject;
class Object;
class System;

// Loads the image `path` ("/MS/OPEN-R/MW/OBJS/JOINTMOV.BIN") as object `id` of `robot`, from the
// file `file` of the stick, or if this is "" from `path`.  If the image cannot be loaded, returns
// null and adds an error finding that begins with `where`, the reason of the load: "OBJECT.CFG:3"
// or "reload".
std::unique_ptr<ImageObject> OpenImage(System* system, int robot, ObjectId id,
                                       const std::string& path, const std::string& where,
                                       const std::string& file = "");

// Does as OpenImage(), and adds the object to `system`.  Returns the object, or null.
Object* LoadImage(System* system, int robot, const std::string& path, const std::string& where,
                  const std::string& file = "");

}  // namespace openr_host
