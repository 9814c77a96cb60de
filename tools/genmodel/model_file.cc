#include "model_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <fstream>
#include <nlohmann/json.hpp>
#include <numbers>
#include <stdexcept>

namespace openr_host::genmodel {
namespace {

using nlohmann::json;

int32_t UradFromDeg(double deg) {
  return static_cast<int32_t>(std::lround(deg * std::numbers::pi / 180.0 * 1e6));
}
int32_t CdegFromDeg(double deg) { return static_cast<int32_t>(std::lround(deg * 100.0)); }

// A limit is rounded towards the inside: 12062.5 hundredths are over the 120.625 degree/s allowed.
int32_t CdegBelow(double deg) { return static_cast<int32_t>(std::floor(deg * 100.0 + 1e-6)); }

// Rows of a list that may be missing altogether (the ERS-220 has no plungers).
json Rows(const json& model, const char* list) {
  return model.contains(list) ? model.at(list).at("rows") : json::array();
}

// The sensor vector carries the angle of every joint, and there its title.
std::string TitleOfJoint(const json& model, int sensor) {
  return model.at("sensors").at("rows").at(sensor).at("name").get<std::string>();
}

Joint ReadJoint(const json& model, const json& row) {
  Joint joint;
  joint.name = row.at("name");
  joint.locator = row.at("locator");
  joint.sensor = row.at("sensor");
  joint.title = TitleOfJoint(model, joint.sensor);
  joint.mtn = row.value("mtn", -1);
  const auto soft = row.at("soft").get<std::array<double, 2>>();
  joint.min_urad = UradFromDeg(soft[0]);
  joint.max_urad = UradFromDeg(soft[1]);
  joint.min_cdeg = CdegFromDeg(soft[0]);
  joint.max_cdeg = CdegFromDeg(soft[1]);
  const auto speed = row.at("speed").get<std::array<double, 2>>();
  joint.min_speed_cdeg = CdegFromDeg(speed[0]);
  joint.max_speed_cdeg = CdegBelow(speed[1]);
  joint.gain = row.at("pid").get<std::vector<int>>();
  if (joint.gain.size() != 6) {
    throw std::runtime_error(
        fmt::format("joint '{}': 'pid' has {} numbers, needs 6 (P, I, D and their shifts)",
                    joint.name, joint.gain.size()));
  }
  return joint;
}

// Hohl 2004, 5.3.5: a head sensor counts as touched beyond half of its upper limit.
int32_t TouchLimit(const std::string& kind, const json& row) {
  if (kind == "switch") return 0;
  if (kind == "force" || kind == "raw") return row.at("range").at(1).get<int32_t>() / 2;
  return -1;
}

Posture ReadPosture(const json& row, const std::vector<Joint>& joints) {
  Posture posture;
  posture.name = row.at("name");
  const auto degrees = row.at("degrees").get<std::vector<double>>();
  if (degrees.size() != joints.size()) {
    throw std::runtime_error(fmt::format("posture '{}' has {} angles for {} joints", posture.name,
                                         degrees.size(), joints.size()));
  }
  for (size_t j = 0; j < joints.size(); ++j) {
    posture.urad.push_back(
        std::clamp(UradFromDeg(degrees[j]), joints[j].min_urad, joints[j].max_urad));
  }
  return posture;
}

Model Convert(const json& source) {
  Model model;
  model.design = source.at("design");
  for (const json& row : Rows(source, "joints")) model.joints.push_back(ReadJoint(source, row));
  for (const json& row : Rows(source, "leds"))
    model.leds.push_back({row.at("name"), row.at("locator"), row.at("type")});
  for (const json& row : Rows(source, "plungers")) {
    model.plungers.push_back({row.at("name"), row.at("locator"), row.at("type")});
  }
  for (const json& row : Rows(source, "sensors")) {
    const int index = model.sensor_elements++;
    const std::string kind = row.at("kind");
    if (kind == "joint") continue;
    model.sensors.push_back(
        {row.at("name"), row.at("locator"), kind, index, TouchLimit(kind, row)});
  }
  const json& camera = source.at("camera");
  const json& layer = camera.at("layers").at(0);
  model.camera = {camera.at("locator"), layer.at(0), layer.at(1),
                  UradFromDeg(camera.at("fov").at(0))};
  for (const json& row : Rows(source, "postures"))
    model.postures.push_back(ReadPosture(row, model.joints));
  const json& acceleration = source.at("acceleration");
  model.min_acceleration_cdeg = CdegFromDeg(acceleration.at("min"));
  model.default_acceleration_cdeg = CdegFromDeg(acceleration.at("default"));
  model.max_acceleration_cdeg = CdegBelow(acceleration.at("max"));
  return model;
}

}  // namespace

Model ReadModel(const std::string& path) {
  std::ifstream file(path);
  if (!file) throw std::runtime_error(fmt::format("cannot read robot model {}", path));
  try {
    return Convert(json::parse(file));
  } catch (const std::exception& error) {
    throw std::runtime_error(fmt::format("robot model {}: {}", path, error.what()));
  }
}

}  // namespace openr_host::genmodel
