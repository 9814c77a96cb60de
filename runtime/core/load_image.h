// Loads images, the files with the code of objects, from the Memory Stick of a robot.
#pragma once

#include <cstdint>
#include <memory>
#include <string>

#include "runtime/core/message.h"

namespace openr_host {

class ImageObject;
class Object;
class System;

// Loads an image of the stick as object `id` of `robot`.  `path` is the path of the image
// ("/MS/OPEN-R/MW/OBJS/JOINTMOV.BIN").  If `file` is not "", loads this file of the stick instead.
// `where` names the reason of the load, "OBJECT.CFG:3" or "reload".  If the image cannot be loaded,
// returns null and adds an error finding that begins with `where`.  The reply boxes that
// constructors of the image open get numbers above `last_box`.
std::unique_ptr<ImageObject> OpenImage(System* system, int robot, ObjectId id,
                                       const std::string& path, const std::string& where,
                                       const std::string& file = "", uint64_t last_box = 0);

// Loads an image of the stick of `robot`, as OpenImage() does, but with a new object id, and adds
// the object to `system`.  Returns the object; null if the image cannot be loaded.
Object* LoadImage(System* system, int robot, const std::string& path, const std::string& where,
                  const std::string& file = "", uint64_t last_box = 0);

}  // namespace openr_host
