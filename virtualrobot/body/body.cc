#include "virtualrobot/body/body.h"

namespace openr_host {

std::vector<WorldThing> Body::MovableThings() const {
  std::vector<WorldThing> things = world().things;
  std::erase_if(things, [](const WorldThing& thing) { return thing.mass_kg == 0; });
  return things;
}

}  // namespace openr_host
