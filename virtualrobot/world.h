// The surroundings of a robot: a floor and static boxes.  docs/worlds.md describes the file format.
#pragma once

#include <Eigen/Core>
#include <string>
#include <vector>

namespace openr_host {

class Hasher;

// A static box in the world W; W has z up and its floor at z = 0.
struct WorldBox {
  std::string name;                   // named in errors about this box
  Eigen::Vector3d size_m{0, 0, 0};    // full edges, each > 0
  Eigen::Vector3d centre_m{0, 0, 0};  // centre of the box, in W
  double yaw_rad = 0;                 // about z, counterclockwise seen from above
};

struct World {
  std::string name = "flat";
  double floor_friction = 0.6;  // Coulomb coefficient of floor and boxes, >= 0
  std::vector<WorldBox> boxes;
};

// Reads a world file (JSON).  Throws std::runtime_error naming file, field and value.
World LoadWorld(const std::string& path);

// Reads a world from text; `name` is the name of the file in errors.
World ParseWorld(const std::string& text, const std::string& name);

void HashWorld(const World& world, Hasher* hasher);

// Distance in metres from `p_W` along the unit vector `direction_W` to the floor or
// the first box; `max_m` when nothing is nearer.  0 from inside a box or below the floor.
double RayDistance(const World& world, const Eigen::Vector3d& p_W,
                   const Eigen::Vector3d& direction_W, double max_m);

}  // namespace openr_host
