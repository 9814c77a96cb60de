// Loads images from the Memory Stick of a robot.
#pragma once

#include <memory>
#include <string>

#include "runtime/core/message.h"

namespace openr_host {

class ImageObject;
class Object;
class System;

// Loads the image "/MS/OPEN-R/MW/OBJS/JOINTMOV.BIN" or its like as object `id` of `robot`.  Null,
// and an error finding that begins with `where`, if it cannot be loaded.
std::unique_ptr<ImageObject> OpenImage(System* system, int robot, ObjectId id,
                                       const std::string& path, const std::string& where);

// Does the same for a new object, which `system` takes.
Object* LoadImage(System* system, int robot, const std::string& path, const std::string& where);

}  // namespace openr_host
