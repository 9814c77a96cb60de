// The fuzz target world: world files.
#include "virtualrobot/worlds/world.h"

#include <stdexcept>

#include "tests/fuzz/fuzz_targets.h"
#include "tests/fuzz/target_list.h"

namespace openr_host {

bool fuzz::world(std::string_view bytes) {
  try {
    const World world = ParseWorld(std::string(bytes), "world.json");
    for (int robot = 0; robot < 4; ++robot) StartOf(world, robot);
    return world.things.size() > 2 && world.things[1].shape == ThingShape::kSphere;
  } catch (const std::runtime_error&) {
    return false;
  }
}

}  // namespace openr_host
