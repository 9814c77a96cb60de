// Reads model files (model/*.json) into a RobotModel.  Converts units to SI and names to indices,
// and refuses impossible values.
#include <cmath>
#include <nlohmann/json.hpp>
#include <tuple>
#include <utility>

#include "runtime/base/hasher.h"
#include "runtime/base/read_file.h"
#include "virtualrobot/base/det_math.h"
#include "virtualrobot/base/json_reader.h"
#include "virtualrobot/model/robot_model.h"

namespace openr_host {
namespace {

using Eigen::Vector3d;

constexpr int kCameraPixelsMax = 4096;  // limit for the width and the height of a picture
// Least width of a picture.  The image layer with the detected colours is a quarter as wide as the
// picture, and a row of this layer must have room for a tag of 16 bytes (see
// camera/image_layers.h).
constexpr int kCameraWidthMin = 64;
// Limits for speeds, accelerations and lengths in the model.  The values of every robot are far
// below these limits.  Programs convert the values to hundredths of a degree or to millionths of a
// metre in integers of 32 bits, and greater values could overflow there.
constexpr double kSpeedMax_deg_s = 100'000;
constexpr double kAccelerationMax_deg_s2 = 1'000'000;
constexpr double kPawRadiusMax_mm = 1000;
constexpr double kDistanceMax_mm = 100'000;

std::vector<JsonReader> Rows(const JsonReader& root, const char* table) {
  return root.At(table).At("rows").Elements();
}

Vector3d Metres(const JsonReader& mm) { return mm.Vector() / 1000; }

Vector3d Unit(const JsonReader& direction) {
  const Vector3d v = direction.Vector();
  if (!(v.norm() > 1e-6)) direction.Fail("must be a direction, is [0, 0, 0]");
  return v / v.norm();
}

// Reads a range, a pair of numbers in the file.  `scale` converts the file's unit to the SI unit.
Range Span(const JsonReader& pair, double scale) {
  const std::vector<double> v = pair.Numbers(2);
  if (v[0] > v[1]) pair.Fail("runs from {} to {}, must rise", v[0], v[1]);
  return {v[0] * scale, v[1] * scale};
}

// Reads a number that must be > 0 and at most `max`.
double PositiveUpTo(const JsonReader& number, double max) {
  const double value = number.Number();
  if (!(value > 0 && value <= max)) number.Fail("is {}, must be > 0 and at most {}", value, max);
  return value;
}

int BodyNamed(const RobotModel& model, const JsonReader& name) {
  const int body = model.FindBody(name.Text());
  if (body < 0) name.Fail("no body '{}'", name.Text());
  return body;
}

void ReadBodies(const JsonReader& root, RobotModel* model) {
  for (const JsonReader& row : Rows(root, "bodies")) {
    row.AllowOnly({"name", "mass", "size", "centre"});
    BodyPart body;
    body.name = row.At("name").Text();
    // Refuses the name of a part that occurs twice, because joints and sensors refer to parts by
    // name.
    if (model->FindBody(body.name) >= 0) row.Fail("a second body '{}'", body.name);
    body.mass_kg = row.At("mass").Number() / 1000;
    if (body.mass_kg < 0)
      row.Fail("'{}' has mass {} g, must be >= 0", body.name, body.mass_kg * 1000);
    body.has_box = row.Has("size");
    if (body.has_box) {
      body.size_m = Metres(row.At("size"));
      body.centre_m = Metres(row.At("centre"));
      if (!(body.size_m.minCoeff() > 0)) row.At("size").Fail("'{}': edges must be > 0", body.name);
    }
    model->bodies.push_back(body);
  }
  if (model->bodies.empty()) root.Fail("no body at all");
}

PidGains ReadGains(const JsonReader& pid) {
  const std::vector<JsonReader> v = pid.Elements();
  if (v.size() != 6) pid.Fail("must be [P, I, D, P shift, I shift, D shift]");
  const auto word = [&](int i) { return static_cast<uint16_t>(v[i].Whole(0, 65535)); };
  return {word(0), word(1), word(2), word(3), word(4), word(5)};
}

void ReadJoint(const JsonReader& row, RobotModel* model) {
  row.AllowOnly({"name", "locator", "parent", "child", "axis", "anchor", "soft", "hard", "speed",
                 "pid", "torque", "sensor", "mtn"});
  JointModel joint;
  joint.name = row.At("name").Text();
  joint.locator = row.At("locator").Text();
  if (model->FindJoint(joint.name) >= 0) row.Fail("a second joint '{}'", joint.name);
  joint.parent = BodyNamed(*model, row.At("parent"));
  joint.child = BodyNamed(*model, row.At("child"));
  // Demands that parents come first, because the dynamics compute the place of each part from its
  // parent's place in the order of the bodies.
  if (joint.parent >= joint.child) row.At("child").Fail("must come after its parent in bodies");
  BodyPart& child = model->bodies[joint.child];
  if (child.joint >= 0) row.At("child").Fail("'{}' already hangs on a joint", child.name);
  child.joint = static_cast<int>(model->joints.size());
  joint.axis = row.At("axis").Vector();
  // Accepts only the axes x, y and z, in both directions.  Recognises them by two numbers: the sum
  // of the absolute values of the coordinates, and the length.  Both are 1 only for these axes.
  if (joint.axis.cwiseAbs().sum() != 1 || joint.axis.norm() != 1) {
    row.At("axis").Fail("must be one of the axes of B, as [0, -1, 0]");
  }
  joint.anchor_m = Metres(row.At("anchor"));
  // Takes the position of the joint as the best guess for the centre of mass of the part that the
  // joint moves, because the centre is not known for a part without box.
  if (!child.has_box) child.centre_m = joint.anchor_m;
  joint.soft_rad = Span(row.At("soft"), Radians(1));
  joint.hard_rad = Span(row.At("hard"), Radians(1));
  if (joint.soft_rad.min < joint.hard_rad.min || joint.soft_rad.max > joint.hard_rad.max) {
    row.At("soft").Fail("must lie inside 'hard'");
  }
  if (joint.hard_rad.max - joint.hard_rad.min <= 0) row.At("hard").Fail("leaves no room to move");
  if (joint.hard_rad.min < Radians(-360) || joint.hard_rad.max > Radians(360))
    row.At("hard").Fail("must lie between -360 and 360 degrees");
  joint.speed_rad_s = Span(row.At("speed"), Radians(1));
  if (!(joint.speed_rad_s.min > 0)) row.At("speed").Fail("must be > 0");
  for (const JsonReader& limit : row.At("speed").Elements()) PositiveUpTo(limit, kSpeedMax_deg_s);
  joint.gains = ReadGains(row.At("pid"));
  if (row.Has("torque")) joint.stall_torque_nm = row.At("torque").NumberAbove(0);
  joint.sensor = static_cast<int>(row.At("sensor").Whole(0, 255));
  if (row.Has("mtn")) joint.mtn = static_cast<int>(row.At("mtn").Whole(0, 255));
  model->joints.push_back(joint);
}

void ReadJoints(const JsonReader& root, RobotModel* model) {
  for (const JsonReader& row : Rows(root, "joints")) ReadJoint(row, model);
  for (size_t i = 1; i < model->bodies.size(); ++i) {
    if (model->bodies[i].joint < 0) root.Fail("body '{}' hangs on no joint", model->bodies[i].name);
  }
}

SensorKind KindOf(const JsonReader& kind) {
  const std::string text = kind.Text();
  if (text == "joint") return SensorKind::kJoint;
  if (text == "force") return SensorKind::kForce;
  if (text == "distance") return SensorKind::kDistance;
  if (text == "switch") return SensorKind::kSwitch;
  if (text == "temperature") return SensorKind::kTemperature;
  if (text == "acceleration") return SensorKind::kAcceleration;
  if (text == "raw") return SensorKind::kRaw;
  kind.Fail("is '{}', must be joint, force, distance, switch, temperature, acceleration or raw",
            text);
}

std::vector<DistanceRow> ReadLookup(const JsonReader& table) {
  std::vector<DistanceRow> rows;
  for (const JsonReader& row : table.Elements()) {
    const std::vector<double> v = row.Numbers(3);
    const std::vector<JsonReader> numbers = row.Elements();
    numbers[0].NumberWithin(0, kDistanceMax_mm);
    numbers[1].NumberWithin(0, kDistanceMax_mm);
    numbers[2].NumberWithin(0, 1);
    if (!rows.empty() && v[0] / 1000 <= rows.back().distance_m) row.Fail("distances must rise");
    rows.push_back({v[0] / 1000, v[1] / 1000, v[2]});
  }
  if (rows.size() < 2) table.Fail("needs at least two rows");
  return rows;
}

void ReadSensor(const JsonReader& row, RobotModel* model) {
  row.AllowOnly({"name", "short", "locator", "kind", "range", "body", "place", "direction",
                 "lookup", "turn"});
  Sensor sensor;
  sensor.name = row.At("name").Text();
  if (row.Has("short")) {
    sensor.short_name = row.At("short").Text();
    if (!model->SensorsNamed(sensor.short_name).empty())
      row.At("short").Fail("'{}' names another sensor already", sensor.short_name);
  }
  sensor.locator = row.At("locator").Text();
  if (model->FindSensorByLocator(sensor.locator) >= 0) {
    row.At("locator").Fail("'{}' stands twice", sensor.locator);
  }
  sensor.kind = KindOf(row.At("kind"));
  sensor.has_range = row.Has("range");
  if (sensor.has_range) {
    Span(row.At("range"), 1);  // refuses a range from a larger to a smaller number
    const std::vector<JsonReader> limits = row.At("range").Elements();
    sensor.min = limits[0].Whole(INT32_MIN, INT32_MAX);  // a sensor value of OPEN-R has 32 bits
    sensor.max = limits[1].Whole(INT32_MIN, INT32_MAX);
  }
  if (row.Has("body")) sensor.body = BodyNamed(*model, row.At("body"));
  if (row.Has("place")) sensor.place_m = Metres(row.At("place"));
  if (row.Has("direction")) sensor.direction = Unit(row.At("direction"));
  if (row.Has("lookup")) sensor.lookup = ReadLookup(row.At("lookup"));
  if (row.Has("turn")) sensor.turn = static_cast<int>(row.At("turn").Whole(0, 1));
  if (sensor.kind == SensorKind::kDistance && sensor.body >= 0) {
    row.At("place"), row.At("direction"), row.At("lookup");  // refuses a row without these members
  }
  const int index = static_cast<int>(model->sensors.size());
  if (sensor.kind == SensorKind::kJoint) {
    sensor.joint = model->FindJointByLocator(sensor.locator);
    if (sensor.joint < 0) row.At("locator").Fail("no joint has '{}'", sensor.locator);
    const JointModel& joint = model->joints[sensor.joint];
    // Checks that the joint's row names the index of this sensor.  The rows of a joint and of its
    // sensor both say that the two belong together, so the rows could contradict each other.
    if (joint.sensor != index) {
      row.Fail("joint '{}' says it is sensor {}, the list says {}", joint.name, joint.sensor,
               index);
    }
  }
  model->sensors.push_back(sensor);
}

// Refuses a joint without a sensor, because programs open a joint by the primitive of its sensor.
void CheckJointSensors(const JsonReader& root, const RobotModel& model) {
  const std::vector<JsonReader> rows = Rows(root, "joints");
  for (size_t j = 0; j < rows.size(); ++j) {
    const auto sensor = static_cast<size_t>(model.joints[j].sensor);
    if (sensor < model.sensors.size() && model.sensors[sensor].joint == static_cast<int>(j))
      continue;
    rows[j].At("sensor").Fail("is {}, but sensor {} of the list does not measure '{}'", sensor,
                              sensor, model.joints[j].name);
  }
}

void ReadPaws(const JsonReader& root, RobotModel* model) {
  for (const JsonReader& row : Rows(root, "paws")) {
    row.AllowOnly({"leg", "body", "centre", "radius", "sensor"});
    Paw paw;
    paw.leg = row.At("leg").Text();
    paw.body = BodyNamed(*model, row.At("body"));
    paw.centre_m = Metres(row.At("centre"));
    paw.radius_m = PositiveUpTo(row.At("radius"), kPawRadiusMax_mm) / 1000;
    paw.sensor = model->FindSensorByLocator(row.At("sensor").Text());
    if (paw.sensor < 0) row.At("sensor").Fail("no sensor '{}'", row.At("sensor").Text());
    model->sensors[paw.sensor].paw = static_cast<int>(model->paws.size());
    model->paws.push_back(paw);
  }
}

void ReadProtection(const JsonReader& table, RobotModel* model) {
  table.AllowOnly({"source", "hot", "hot_charging", "current", "jam"});
  Limits& limits = model->protection;
  if (table.Has("hot")) limits.hot_c = static_cast<int>(table.At("hot").Whole(1, 200));
  if (table.Has("hot_charging"))
    limits.hot_charging_c = static_cast<int>(table.At("hot_charging").Whole(1, 200));
  if (table.Has("current"))
    limits.current_ma = static_cast<int>(table.At("current").Whole(1, 100'000));
  if (table.Has("jam")) limits.jam_frames = static_cast<int>(table.At("jam").Whole(8, 60'000)) / 8;
}

void ReadLights(const JsonReader& root, RobotModel* model) {
  for (const JsonReader& row : Rows(root, "leds")) {
    row.AllowOnly({"name", "locator", "type", "colour", "colour_b"});
    model->leds.push_back({row.At("name").Text(), row.At("locator").Text(), row.At("type").Text(),
                           row.Has("colour") ? row.At("colour").Text() : "",
                           row.Has("colour_b") ? row.At("colour_b").Text() : ""});
  }
  if (!root.Has("plungers")) return;  // a robot may have no ears (plungers), as the ERS-220
  for (const JsonReader& row : Rows(root, "plungers")) {
    row.AllowOnly({"name", "locator", "type", "on_rad", "off_rad", "place", "settle_ms", "mtn"});
    Plunger plunger;
    plunger.name = row.At("name").Text();
    plunger.locator = row.At("locator").Text();
    plunger.type = row.At("type").Text();
    if (row.Has("on_rad")) plunger.on_rad = row.At("on_rad").Number();
    if (row.Has("off_rad")) plunger.off_rad = row.At("off_rad").Number();
    if (row.Has("place")) plunger.place_m = Metres(row.At("place"));
    if (row.Has("settle_ms"))
      plunger.settle_ms = static_cast<int>(row.At("settle_ms").Whole(1, 10000));
    if (row.Has("mtn")) plunger.mtn = static_cast<int>(row.At("mtn").Whole(0, 255));
    model->plungers.push_back(plunger);
  }
}

// Reads the width and the height of a picture of the camera from a model file.
std::pair<int, int> PixelsOf(const JsonReader& size) {
  const std::vector<JsonReader> v = size.Elements();
  if (v.size() != 2) size.Fail("must be [width, height]");
  const auto pixels = [&](int i) { return static_cast<int>(v[i].Whole(1, kCameraPixelsMax)); };
  return {pixels(0), pixels(1)};
}

void ReadCamera(const JsonReader& camera, RobotModel* model) {
  Camera& c = model->camera;
  c.locator = camera.At("locator").Text();
  c.body = BodyNamed(*model, camera.At("body"));
  c.place_m = Metres(camera.At("place"));
  c.direction = Unit(camera.At("direction"));
  std::tie(c.width_px, c.height_px) = PixelsOf(camera.At("pixels"));
  c.frames_per_s = camera.At("fps").NumberAbove(0);
  if (c.frames_per_s > 125)
    camera.At("fps").Fail("is {}, must be at most 125 (one in 8 ms)", c.frames_per_s);
  const std::vector<double> fov = camera.At("fov").Numbers(2);
  // Refuses a camera whose angle of view is 180 degrees or more, because its picture would be
  // infinitely wide.
  for (const JsonReader& angle : camera.At("fov").Elements()) {
    if (angle.NumberAbove(0) >= 180) angle.Fail("is {}, must be < 180", angle.Number());
  }
  c.fov_h_rad = Radians(fov[0]);
  c.fov_v_rad = Radians(fov[1]);
  if (c.width_px % 8 != 0 || c.height_px % 8 != 0)
    camera.At("pixels").Fail("{} x {} cannot be halved three times", c.width_px, c.height_px);
  if (c.width_px < kCameraWidthMin)
    camera.At("pixels").Fail("{} wide, must be {} or more", c.width_px, kCameraWidthMin);
  // Checks that each layer of the image has half the width and half the height of the layer before,
  // because the camera computes the layers with these sizes and not with those of the file.
  const std::vector<JsonReader> layers = camera.At("layers").Elements();
  if (layers.size() > 3) camera.At("layers").Fail("has {} layers, at most 3", layers.size());
  for (size_t i = 0; i < layers.size(); ++i) {
    const auto [width_px, height_px] = PixelsOf(layers[i]);
    const int half = 2 << i;
    if (width_px != c.width_px / half || height_px != c.height_px / half) {
      layers[i].Fail("is {} x {}; every layer is half of the one above it, here {} x {}", width_px,
                     height_px, c.width_px / half, c.height_px / half);
    }
  }
}

void ReadPostures(const JsonReader& root, RobotModel* model) {
  for (const JsonReader& row : Rows(root, "postures")) {
    row.AllowOnly({"name", "source", "degrees"});
    Posture posture{row.At("name").Text(), row.At("degrees").Numbers(model->joints.size())};
    for (size_t j = 0; j < model->joints.size(); ++j) {
      const JointModel& joint = model->joints[j];
      const double degrees = posture.angles_rad[j];
      posture.angles_rad[j] = Radians(degrees);
      // Allows half a degree beyond a mechanical stop of the joint, because postures that were
      // measured at a stop of a real robot may be wrong by half a degree.
      if (degrees < Degrees(joint.hard_rad.min) - 0.5 ||
          degrees > Degrees(joint.hard_rad.max) + 0.5) {
        row.At("degrees").Fail("posture '{}' asks {} for {} degrees, its stops are at {} and {}",
                               posture.name, joint.name, degrees,
                               std::round(Degrees(joint.hard_rad.min) * 10) / 10,
                               std::round(Degrees(joint.hard_rad.max) * 10) / 10);
      }
    }
    model->postures.push_back(posture);
  }
  for (const char* needed : {"sleep", "stand"}) {
    try {
      model->PostureAngles(needed);
    } catch (const std::runtime_error&) {
      root.At("postures")
          .Fail("'{}' is missing; robots start asleep and are judged standing", needed);
    }
  }
}

}  // namespace

RobotModel ParseRobotModel(const std::string& text, const std::string& file_name) {
  const nlohmann::json json = JsonReader::ParseText(text, file_name);
  const JsonReader root(json, file_name);
  if (root.At("schema").Text() != "openr-host robot model 1") {
    root.At("schema").Fail("is '{}', this program reads 'openr-host robot model 1'",
                           root.At("schema").Text());
  }
  RobotModel model;
  model.name = root.At("name").Text();
  model.design = root.At("design").Text();
  for (const JsonReader& label : root.At("mtn_labels").Elements()) {
    model.mtn_labels.push_back(label.Text());
  }
  // Reads the tables of the model file in this order, because joints name bodies, sensors name
  // joints, and paws name sensors.
  ReadBodies(root, &model);
  ReadJoints(root, &model);
  for (const JsonReader& row : Rows(root, "sensors")) ReadSensor(row, &model);
  CheckJointSensors(root, model);
  ReadPaws(root, &model);
  if (root.At("paws").Has("force")) model.paw_force_n = root.At("paws").At("force").NumberAbove(0);
  if (root.Has("protection")) ReadProtection(root.At("protection"), &model);
  ReadLights(root, &model);
  ReadCamera(root.At("camera"), &model);
  const auto acceleration_rad_s2 = [&root](const char* which) {
    return Radians(PositiveUpTo(root.At("acceleration").At(which), kAccelerationMax_deg_s2));
  };
  model.accel_min_rad_s2 = acceleration_rad_s2("min");
  model.accel_default_rad_s2 = acceleration_rad_s2("default");
  model.accel_max_rad_s2 = acceleration_rad_s2("max");
  if (model.accel_min_rad_s2 > model.accel_default_rad_s2 ||
      model.accel_default_rad_s2 > model.accel_max_rad_s2)
    root.At("acceleration").Fail("min, default and max must not fall");
  model.speaker_locator = root.At("audio").At("speaker").Text();
  model.microphone_locator = root.At("audio").At("microphone").Text();
  model.microphone_frames = static_cast<int>(root.At("audio").At("microphone_frames").Whole(1, 16));
  ReadPostures(root, &model);
  model.content_hash = HashBytes(text.data(), text.size());
  return model;
}

RobotModel LoadRobotModel(const std::string& path) {
  return ParseRobotModel(ReadFileOrThrow(path), path);
}

}  // namespace openr_host
