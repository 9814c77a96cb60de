// The surroundings of a robot: a floor and things on it.  docs/worlds.md describes the format of
// world files.
#pragma once

#include <Eigen/Core>
#include <memory>
#include <string>
#include <vector>

namespace openr_host {

class Hasher;

enum class ThingShape { kBox, kSphere, kCylinder, kHeightField };

struct HeightGrid;  // defined in height_grid.h

// A thing in the world frame W, which has z up and the floor at z = 0.
struct WorldThing {
  std::string name;  // name of the thing in error messages and reports
  ThingShape shape = ThingShape::kBox;
  // The size of the thing: for a box the lengths of its edges; for a sphere its diameter in x, y
  // and z; for a cylinder its diameter in x and y, and its length in z; for a heightfield the edges
  // of the box that holds it.  All numbers are > 0.
  Eigen::Vector3d size_m{0, 0, 0};
  Eigen::Vector3d centre_m{0, 0, 0};                   // place of the thing's centre in the world W
  Eigen::Matrix3d R_WT = Eigen::Matrix3d::Identity();  // rotation from the thing's own axes T to W
  Eigen::Vector3d colour{0.72, 0.60, 0.46};            // red, green and blue, 0 to 1
  // Mass of the thing; 0: the thing is fixed.  If the mass is > 0, robots and other things can move
  // the thing.
  double mass_kg = 0;
  // false: the thing is paint on the floor, which cameras see but nothing touches
  bool is_solid = true;
  double reflectance = 1;  // share of a distance sensor's infrared light that the thing reflects
  // Surface of a heightfield; null for other shapes.
  std::shared_ptr<const HeightGrid> heights = {};
};

// The place of a robot at its first boot: where the origin of its base B is above the floor, and
// how far it is turned, counterclockwise from above.
struct StartPlace {
  double x_m = 0, y_m = 0, yaw_rad = 0;
};

struct World {
  std::string name = "flat";
  double floor_friction = 0.6;  // Coulomb friction coefficient of floor and things, >= 0
  Eigen::Vector3d floor_colour{0.62, 0.62, 0.60};  // red, green and blue, 0 to 1
  double floor_reflectance = 1;
  // Unit vector from the things towards the light.
  Eigen::Vector3d to_light{0.48, 0.36, 0.8};
  // Share of the light that comes from all directions, 0 to 1.
  double ambient = 0.55;
  std::vector<WorldThing> things;
  std::vector<StartPlace> starts = {};  // for each robot, its place at the beginning; may be empty
};

// Returns the place at which the robot with the number `robot` begins: World::starts[robot].  In a
// world without such places, the robots begin beside each other, 0.5 m apart.  Throws
// std::runtime_error when the world has places, but none for this robot.
StartPlace StartOf(const World& world, int robot);

// Reads a world file (JSON).  Throws std::runtime_error with file, field and value when the file
// cannot be read or has a mistake.
World LoadWorld(const std::string& path);

// Reads a world from `text`, the text of a world file.  Error messages call this file `file_name`.
World ParseWorld(const std::string& text, const std::string& file_name);

void HashWorld(const World& world, Hasher* hasher);

// The first surface that a ray meets: its distance, and the share of infrared light that it
// reflects.
struct RayHit {
  double distance_m = 0;
  double reflectance = 1;
};

// Follows the ray from `p_W` along the unit vector `direction_W`, up to the distance
// `hit->distance_m`.  Sets `hit` to the first solid thing of `things` that the ray meets.  Does not
// change `hit` if the ray meets no solid thing.
void CastRayOnThings(const std::vector<WorldThing>& things, const Eigen::Vector3d& p_W,
                     const Eigen::Vector3d& direction_W, RayHit* hit);

// Follows a ray from `p_W` along the unit vector `direction_W` to the floor or the first solid
// thing of `things`.  The distance is `max_m` when nothing is nearer, and 0 when `p_W` is inside a
// thing or below the floor.
RayHit CastRay(const World& world, const std::vector<WorldThing>& things,
               const Eigen::Vector3d& p_W, const Eigen::Vector3d& direction_W, double max_m);

}  // namespace openr_host
