// The surroundings of a robot: a floor and static boxes.  docs/worlds.md describes the format of
// world files.
#pragma once

#include <Eigen/Core>
#include <string>
#include <vector>

namespace openr_host {

class Hasher;

// A static box in the world frame W, which has z up and the floor at z = 0.
struct WorldBox {
  std::string name;                   // name of the box in error messages
  Eigen::Vector3d size_m{0, 0, 0};    // lengths of the edges, each > 0
  Eigen::Vector3d centre_m{0, 0, 0};  // centre of the box, in W
  double yaw_rad = 0;                 // rotation about z, counterclockwise seen from above
};

struct World {
  std::string name = "flat";
  double floor_friction = 0.6;  // Coulomb friction coefficient of floor and boxes, >= 0
  std::vector<WorldBox> boxes;
};

// Reads a world file (JSON).  Throws std::runtime_error with file, field and value when the file
// cannot be read or has a mistake.
World LoadWorld(const std::string& path);

// Reads a world from `text`; errors name the file as `name`.
World ParseWorld(const std::string& text, const std::string& name);

void HashWorld(const World& world, Hasher* hasher);

// Returns the distance in metres from `p_W` along the unit vector `direction_W` to the floor or the
// first box; `max_m` when nothing is nearer; 0 when `p_W` is inside a box or below the floor.
double RayDistance(const World& world, const Eigen::Vector3d& p_W,
                   const Eigen::Vector3d& direction_W, double max_m);

}  // namespace openr_host
