// Reads world files (docs/worlds.md).
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <nlohmann/json.hpp>
#include <set>
#include <utility>

#include "runtime/base/read_file.h"
#include "virtualrobot/base/det_math.h"
#include "virtualrobot/base/json_reader.h"
#include "virtualrobot/base/rotation.h"
#include "virtualrobot/worlds/height_grid.h"
#include "virtualrobot/worlds/world.h"

namespace openr_host {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

// Largest number of steps of stairs.
constexpr int kStepsMax = 100;
// Largest number of things in a world.
constexpr size_t kThingsMax = 1000;
// Largest number of points of a heightfield along x and along y.
constexpr int kGridMax = 64;
// Largest size of a thing, and largest distance of its centre from the origin along an axis.
constexpr double kPlaceMax_m = 1000;
constexpr double kAngleMax_deg = 360;
// Limits for a thing that can move: its least and largest mass, and its smallest length.
constexpr double kMassMin_kg = 0.001, kMassMax_kg = 1000, kMovableMin_m = 0.005;
// Largest thickness of a thing that the world file calls paint on the floor, and largest height of
// its centre above the floor.
constexpr double kPaintMax_m = 0.01;
// Thickness of the board that is a ramp.  A falling part moves less than this thickness in a frame,
// so it cannot pass through the board.
constexpr double kRampThickness_m = 0.1;

// Reads `yaw_deg`, the angle of a thing about the vertical, and returns the angle in radians; 0 if
// the file does not give it.
double YawOf(const JsonReader& row) {
  if (!row.Has("yaw_deg")) return 0;
  const double yaw_deg = row.At("yaw_deg").Number();
  if (std::fabs(yaw_deg) > kAngleMax_deg)
    row.At("yaw_deg").Fail("is {}, must be -{} to {}", yaw_deg, kAngleMax_deg, kAngleMax_deg);
  return Radians(yaw_deg);
}

// Reads `yaw_deg` and returns the rotation of a thing about the vertical; no rotation if the file
// does not give it.
Matrix3d YawRotationOf(const JsonReader& row) {
  return row.Has("yaw_deg") ? RotationFromRpy({0, 0, YawOf(row)}) : Matrix3d::Identity();
}

// Reads `rpy_deg` and returns the rotation of a thing (roll, pitch and yaw); no rotation if the
// file does not give it.
Matrix3d RpyRotationOf(const JsonReader& row) {
  if (!row.Has("rpy_deg")) return Matrix3d::Identity();
  const Vector3d rpy_deg = row.At("rpy_deg").Vector();
  if (rpy_deg.cwiseAbs().maxCoeff() > kAngleMax_deg) {
    row.At("rpy_deg").Fail("is [{}, {}, {}], angles must be -{} to {}", rpy_deg.x(), rpy_deg.y(),
                           rpy_deg.z(), kAngleMax_deg, kAngleMax_deg);
  }
  return RotationFromRpy(rpy_deg * Radians(1.0));
}

Vector3d ColourOf(const JsonReader& value) {
  const Vector3d colour = value.Vector();
  if (colour.minCoeff() < 0 || colour.maxCoeff() > 1) {
    value.Fail("is [{}, {}, {}]; red, green and blue must be 0 to 1", colour.x(), colour.y(),
               colour.z());
  }
  return colour;
}

// Reads the mass of a thing that can be moved.  Refuses a thing that is so light or so thin that
// its inertia would be almost 0.
void ReadMass(const JsonReader& row, WorldThing* thing) {
  thing->mass_kg = row.At("mass_kg").Number();
  if (!(thing->mass_kg >= kMassMin_kg && thing->mass_kg <= kMassMax_kg)) {
    row.At("mass_kg").Fail("is {}, must be {} to {}", thing->mass_kg, kMassMin_kg, kMassMax_kg);
  }
  if (!(thing->size_m.minCoeff() >= kMovableMin_m)) {
    row.At("mass_kg").Fail("belongs to '{}', which is {} m thin; what moves must have {} m",
                           thing->name, thing->size_m.minCoeff(), kMovableMin_m);
  }
}

// Reads whether a thing is solid.  Reads the mass of a solid thing that can move.  Checks that a
// thing that is not solid is paint on the floor.
void ReadMatter(const JsonReader& row, WorldThing* thing) {
  if (row.Has("solid")) thing->is_solid = row.At("solid").Bool();
  if (thing->is_solid) {
    if (row.Has("mass_kg")) ReadMass(row, thing);
    return;
  }
  for (const char* const field : {"mass_kg", "rpy_deg"}) {
    if (row.Has(field))
      row.At(field).Fail("'{}' is paint on the floor, which has none", thing->name);
  }
  if (thing->size_m.z() > kPaintMax_m || std::fabs(thing->centre_m.z()) > kPaintMax_m) {
    row.At("solid").Fail(
        "'{}' is {} m high and its middle at {} m; paint lies on the floor, with at most {} m each",
        thing->name, thing->size_m.z(), thing->centre_m.z(), kPaintMax_m);
  }
}

// Reads the lengths of the edges of a box, a ramp or stairs; `shape` is the name of the shape in
// error messages.
Vector3d EdgesOf(const JsonReader& row, const WorldThing& thing, const char* shape) {
  const Vector3d size_m = row.At("size_m").Vector();
  if (!(size_m.minCoeff() > 0)) {
    row.At("size_m").Fail("{} '{}' is {} x {} x {} m, edges must be > 0", shape, thing.name,
                          size_m.x(), size_m.y(), size_m.z());
  }
  return size_m;
}

void ReadBox(const JsonReader& row, WorldThing thing, std::vector<WorldThing>* things) {
  row.AllowOnly({"shape", "name", "colour", "reflectance", "mass_kg", "solid", "size_m", "centre_m",
                 "yaw_deg", "rpy_deg"});
  thing.size_m = EdgesOf(row, thing, "box");
  thing.centre_m = row.At("centre_m").Vector();
  if (row.Has("rpy_deg")) {
    if (row.Has("yaw_deg")) row.At("yaw_deg").Fail("stands beside 'rpy_deg'; leave one out");
    thing.R_WT = RpyRotationOf(row);
  } else {
    thing.R_WT = YawRotationOf(row);
  }
  ReadMatter(row, &thing);
  things->push_back(thing);
}

void ReadSphere(const JsonReader& row, WorldThing thing, std::vector<WorldThing>* things) {
  row.AllowOnly({"shape", "name", "colour", "reflectance", "mass_kg", "radius_m", "centre_m"});
  thing.shape = ThingShape::kSphere;
  thing.size_m.setConstant(2 * row.At("radius_m").NumberAbove(0));
  thing.centre_m = row.At("centre_m").Vector();
  ReadMatter(row, &thing);
  things->push_back(thing);
}

void ReadCylinder(const JsonReader& row, WorldThing thing, std::vector<WorldThing>* things) {
  row.AllowOnly({"shape", "name", "colour", "reflectance", "mass_kg", "solid", "radius_m",
                 "height_m", "centre_m", "rpy_deg"});
  thing.shape = ThingShape::kCylinder;
  const double diameter_m = 2 * row.At("radius_m").NumberAbove(0);
  thing.size_m = Vector3d(diameter_m, diameter_m, row.At("height_m").NumberAbove(0));
  thing.centre_m = row.At("centre_m").Vector();
  thing.R_WT = RpyRotationOf(row);
  ReadMatter(row, &thing);
  things->push_back(thing);
}

// Reads a ramp and adds it to `things` as a board.  The upper face of the board rises from
// `start_m` along the board's own x axis.
void ReadRamp(const JsonReader& row, WorldThing thing, std::vector<WorldThing>* things) {
  row.AllowOnly({"shape", "name", "colour", "reflectance", "size_m", "start_m", "yaw_deg"});
  const Vector3d size_m = EdgesOf(row, thing, "ramp");
  const double length_m = std::sqrt(size_m.x() * size_m.x() + size_m.z() * size_m.z());
  thing.size_m = Vector3d(length_m, size_m.y(), kRampThickness_m);
  thing.R_WT = YawRotationOf(row) * RotationFromRpy({0, -DetAtan2(size_m.z(), size_m.x()), 0});
  thing.centre_m =
      row.At("start_m").Vector() + thing.R_WT * Vector3d(length_m / 2, 0, -kRampThickness_m / 2);
  things->push_back(thing);
}

// Reads stairs and adds a box for each step to `things`.  The box reaches from the height of
// `start_m` up to the tread of the step.  The stairs rise from `start_m` along their own x axis.
void ReadStairs(const JsonReader& row, WorldThing thing, std::vector<WorldThing>* things) {
  row.AllowOnly(
      {"shape", "name", "colour", "reflectance", "size_m", "steps", "start_m", "yaw_deg"});
  const Vector3d size_m = EdgesOf(row, thing, "stairs");
  const auto steps = static_cast<int>(row.At("steps").Whole(1, kStepsMax));
  const Vector3d start_m = row.At("start_m").Vector();
  thing.R_WT = YawRotationOf(row);
  const double tread_m = size_m.x() / steps, rise_m = size_m.z() / steps;
  const std::string name = thing.name;
  for (int i = 0; i < steps; ++i) {
    thing.name = fmt::format("{} {}", name, i + 1);
    const double height_m = (i + 1) * rise_m;
    thing.size_m = Vector3d(tread_m, size_m.y(), height_m);
    thing.centre_m = start_m + thing.R_WT * Vector3d((i + 0.5) * tread_m, 0, height_m / 2);
    things->push_back(thing);
  }
}

// Reads a heightfield: rows of heights over its base, which is a rectangle around `centre_m`.
void ReadHeightField(const JsonReader& row, WorldThing thing, std::vector<WorldThing>* things) {
  row.AllowOnly(
      {"shape", "name", "colour", "reflectance", "size_m", "heights_m", "centre_m", "yaw_deg"});
  thing.shape = ThingShape::kHeightField;
  const std::vector<double> base_m = row.At("size_m").Numbers(2);
  for (const double edge_m : base_m) {
    if (!(edge_m > 0)) {
      row.At("size_m").Fail("heightfield '{}' is {} x {} m, edges must be > 0", thing.name,
                            base_m[0], base_m[1]);
    }
  }
  auto grid = std::make_shared<HeightGrid>();
  const JsonReader list = row.At("heights_m");
  const std::vector<JsonReader> lines = list.Elements();
  grid->rows = static_cast<int>(lines.size());
  grid->columns = lines.empty() ? 0 : static_cast<int>(lines[0].Elements().size());
  if (std::min(grid->rows, grid->columns) < 2 || std::max(grid->rows, grid->columns) > kGridMax) {
    list.Fail("has {} rows of {} numbers, must have 2 to {} of each", grid->rows, grid->columns,
              kGridMax);
  }
  double top_m = 0;
  for (const JsonReader& line : lines) {
    for (const double height_m : line.Numbers(static_cast<size_t>(grid->columns))) {
      if (height_m < 0) line.Fail("has {}, heights over the base must be >= 0", height_m);
      grid->heights_m.push_back(height_m);
      top_m = std::max(top_m, height_m);
    }
  }
  if (top_m == 0) list.Fail("are all 0; one must be > 0");
  thing.size_m = Vector3d(base_m[0], base_m[1], top_m);
  thing.centre_m = row.At("centre_m").Vector() + Vector3d(0, 0, top_m / 2);
  thing.R_WT = YawRotationOf(row);
  thing.heights = std::move(grid);
  things->push_back(thing);
}

// Fails if one of the things from index `first` on is larger, or further away, than kPlaceMax_m,
// because sums of doubles are not exact enough for such a thing.
void CheckPlaces(const JsonReader& row, const std::vector<WorldThing>& things, size_t first) {
  for (size_t i = first; i < things.size(); ++i) {
    const WorldThing& thing = things[i];
    if (!(thing.size_m.maxCoeff() <= kPlaceMax_m &&
          thing.centre_m.cwiseAbs().maxCoeff() <= kPlaceMax_m))
      row.Fail("'{}' is larger, or further away, than {} m", thing.name, kPlaceMax_m);
  }
}

void ReadShape(const JsonReader& row, std::vector<WorldThing>* things) {
  WorldThing thing;
  thing.name = row.At("name").Text();
  if (row.Has("colour")) thing.colour = ColourOf(row.At("colour"));
  if (row.Has("reflectance")) thing.reflectance = row.At("reflectance").NumberWithin(0, 1);
  const std::string shape = row.At("shape").Text();
  if (shape == "box") return ReadBox(row, thing, things);
  if (shape == "sphere") return ReadSphere(row, thing, things);
  if (shape == "cylinder") return ReadCylinder(row, thing, things);
  if (shape == "ramp") return ReadRamp(row, thing, things);
  if (shape == "stairs") return ReadStairs(row, thing, things);
  if (shape == "heightfield") return ReadHeightField(row, thing, things);
  row.At("shape").Fail("is '{}'; known are box, sphere, cylinder, ramp, stairs, heightfield",
                       shape);
}

void ReadThing(const JsonReader& row, std::vector<WorldThing>* things) {
  const size_t first = things->size();
  ReadShape(row, things);
  CheckPlaces(row, *things, first);
}

// Reads the places at which robots begin.
void ReadStarts(const JsonReader& rows, std::vector<StartPlace>* starts) {
  for (const JsonReader& row : rows.Elements()) {
    row.AllowOnly({"place_m", "yaw_deg"});
    const std::vector<JsonReader> place = row.At("place_m").Elements();
    if (place.size() != 2)
      row.At("place_m").Fail("has {} numbers, must have x and y", place.size());
    StartPlace start{.x_m = place[0].Number(), .y_m = place[1].Number()};
    if (!(std::fabs(start.x_m) <= kPlaceMax_m && std::fabs(start.y_m) <= kPlaceMax_m))
      row.At("place_m").Fail("is further away than {} m", kPlaceMax_m);
    start.yaw_rad = YawOf(row);
    starts->push_back(start);
  }
}

// Reads the boxes of a world file of version 1, which has no other things.
void ReadBoxes(const JsonReader& root, std::vector<WorldThing>* things) {
  for (const JsonReader& row : root.At("boxes").Elements()) {
    row.AllowOnly({"name", "size_m", "centre_m", "yaw_deg"});
    WorldThing thing;
    thing.name = row.At("name").Text();
    ReadBox(row, thing, things);
    CheckPlaces(row, *things, things->size() - 1);
  }
}

// Reads the direction from which the light comes, and the share of the light that comes from all
// directions.
void ReadLight(const JsonReader& row, World* world) {
  row.AllowOnly({"direction_deg", "ambient"});
  if (row.Has("ambient")) world->ambient = row.At("ambient").NumberWithin(0, 1);
  if (!row.Has("direction_deg")) return;
  const JsonReader direction = row.At("direction_deg");
  const std::vector<double> angles_deg = direction.Numbers(2);
  const double azimuth_deg = angles_deg[0], elevation_deg = angles_deg[1];
  if (std::fabs(azimuth_deg) > kAngleMax_deg || !(elevation_deg >= 0 && elevation_deg <= 90)) {
    direction.Fail("is [{}, {}]; azimuth must be -{} to {}, elevation 0 to 90", azimuth_deg,
                   elevation_deg, kAngleMax_deg, kAngleMax_deg);
  }
  const double azimuth = Radians(azimuth_deg), elevation = Radians(elevation_deg);
  world->to_light = Vector3d(DetCos(elevation) * DetCos(azimuth),
                             DetCos(elevation) * DetSin(azimuth), DetSin(elevation));
}

// Reads what cameras and distance sensors notice: the colour and reflectance of the floor, and the
// light.
void ReadLooks(const JsonReader& root, World* world) {
  if (root.Has("floor_colour")) world->floor_colour = ColourOf(root.At("floor_colour"));
  if (root.Has("floor_reflectance"))
    world->floor_reflectance = root.At("floor_reflectance").NumberWithin(0, 1);
  if (root.Has("light")) ReadLight(root.At("light"), world);
}

void ReadThings(const JsonReader& list, std::vector<WorldThing>* things) {
  for (const JsonReader& row : list.Elements()) ReadThing(row, things);
  if (things->size() > kThingsMax) {
    list.Fail("are {} things, with each step of stairs as one; at most {}", things->size(),
              kThingsMax);
  }
  std::set<std::string> names;
  for (const WorldThing& thing : *things) {
    // Allows fixed things of equal name, because only things that can move are addressed by their
    // names, for example by the input "put".
    if (thing.mass_kg > 0 && !names.insert(thing.name).second)
      list.Fail("has two things '{}' that can move; each needs a name of its own", thing.name);
  }
}

}  // namespace

World ParseWorld(const std::string& text, const std::string& file_name) {
  const nlohmann::json json = JsonReader::ParseText(text, file_name);
  const JsonReader root(json, file_name);
  const std::string schema = root.At("schema").Text();
  World world;
  if (schema == "openr-host world 1") {
    root.AllowOnly({"schema", "name", "friction", "boxes"});
    if (root.Has("boxes")) ReadBoxes(root, &world.things);
  } else if (schema == "openr-host world 2") {
    root.AllowOnly({"schema", "name", "friction", "floor_colour", "floor_reflectance", "light",
                    "things", "starts"});
    ReadLooks(root, &world);
    if (root.Has("things")) ReadThings(root.At("things"), &world.things);
    if (root.Has("starts")) ReadStarts(root.At("starts"), &world.starts);
  } else {
    root.At("schema").Fail(
        "is '{}', this program reads 'openr-host world 1' and 'openr-host world 2'", schema);
  }
  world.name = root.At("name").Text();
  if (root.Has("friction")) {
    world.floor_friction = root.At("friction").Number();
    if (world.floor_friction < 0) {
      root.At("friction").Fail("is {}, must be >= 0", world.floor_friction);
    }
  }
  return world;
}

World LoadWorld(const std::string& path) { return ParseWorld(ReadFileOrThrow(path), path); }

}  // namespace openr_host
