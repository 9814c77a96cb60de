#include "virtualrobot/world.h"

#include <cmath>
#include <limits>
#include <utility>

#include "runtime/base/hasher.h"
#include "runtime/base/read_file.h"
#include "virtualrobot/det_math.h"
#include "virtualrobot/json_reader.h"

namespace openr_host {
namespace {

using Eigen::Vector3d;

// Returns the place where a ray enters the box, as a multiple of `direction_W`: infinite when the
// ray misses the box, 0 when it starts inside.
double EnterBox(const WorldBox& box, const Vector3d& p_W, const Vector3d& direction_W) {
  const double s = DetSin(box.yaw_rad), c = DetCos(box.yaw_rad);
  const Vector3d r = p_W - box.centre_m;
  const Vector3d p(c * r.x() + s * r.y(), c * r.y() - s * r.x(), r.z());
  const Vector3d d(c * direction_W.x() + s * direction_W.y(),
                   c * direction_W.y() - s * direction_W.x(), direction_W.z());
  // p and d are the ray in the frame of the box.  The ray is inside the box while it is between the
  // two faces of each axis.
  double enter = 0, leave = std::numeric_limits<double>::infinity();
  for (int k = 0; k < 3; ++k) {
    const double half = box.size_m[k] / 2;
    if (d[k] == 0) {
      if (std::fabs(p[k]) > half) return std::numeric_limits<double>::infinity();
      continue;
    }
    double near = (-half - p[k]) / d[k], far = (half - p[k]) / d[k];
    if (near > far) std::swap(near, far);
    enter = std::max(enter, near);
    leave = std::min(leave, far);
  }
  return enter <= leave ? enter : std::numeric_limits<double>::infinity();
}

}  // namespace

double RayDistance(const World& world, const Vector3d& p_W, const Vector3d& direction_W,
                   double max_m) {
  double distance_m = max_m;
  if (p_W.z() <= 0) return 0;
  if (direction_W.z() < 0) distance_m = std::min(distance_m, -p_W.z() / direction_W.z());
  for (const WorldBox& box : world.boxes) {
    distance_m = std::min(distance_m, EnterBox(box, p_W, direction_W));
  }
  return distance_m;
}

World ParseWorld(const std::string& text, const std::string& name) {
  const nlohmann::json json = JsonReader::ParseText(text, name);
  const JsonReader root(json, name);
  root.AllowOnly({"schema", "name", "friction", "boxes"});
  if (root.At("schema").Text() != "openr-host world 1") {
    root.At("schema").Fail("is '{}', this program reads 'openr-host world 1'",
                           root.At("schema").Text());
  }
  World world;
  world.name = root.At("name").Text();
  if (root.Has("friction")) {
    world.floor_friction = root.At("friction").Number();
    if (world.floor_friction < 0) {
      root.At("friction").Fail("is {}, must be >= 0", world.floor_friction);
    }
  }
  if (!root.Has("boxes")) return world;
  for (const JsonReader& row : root.At("boxes").Elements()) {
    row.AllowOnly({"name", "size_m", "centre_m", "yaw_deg"});
    WorldBox box;
    box.name = row.At("name").Text();
    box.size_m = row.At("size_m").Vector();
    box.centre_m = row.At("centre_m").Vector();
    if (row.Has("yaw_deg")) box.yaw_rad = Radians(row.At("yaw_deg").Number());
    if (!(box.size_m.minCoeff() > 0)) {
      row.At("size_m").Fail("box '{}' is {} x {} x {} m, edges must be > 0", box.name,
                            box.size_m.x(), box.size_m.y(), box.size_m.z());
    }
    world.boxes.push_back(box);
  }
  return world;
}

World LoadWorld(const std::string& path) { return ParseWorld(ReadFileOrThrow(path), path); }

void HashWorld(const World& world, Hasher* hasher) {
  hasher->Add(world.floor_friction);
  for (const WorldBox& box : world.boxes) {
    hasher->AddBytes(box.size_m.data(), 3 * sizeof(double));
    hasher->AddBytes(box.centre_m.data(), 3 * sizeof(double));
    hasher->Add(box.yaw_rad);
  }
}

}  // namespace openr_host
