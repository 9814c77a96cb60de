// The constants of a robot that the objects need, in the units of the objects: angles in
// micro-radians; limits, speeds and accelerations in hundredths of a degree, rounded to the
// nearest.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "virtualrobot/model/robot_model.h"

namespace openr_host::genmodel {

struct JointRow {
  std::string name, title, locator;
  int32_t min_urad = 0, max_urad = 0;
  int32_t min_cdeg = 0, max_cdeg = 0;
  int32_t min_speed_cdeg = 0, max_speed_cdeg = 0;
  std::vector<int> gain;  // six numbers: P, I and D gain, then their shifts
  int sensor = -1, mtn = -1;
};

struct LightRow {
  std::string title, locator, type;  // types are "LED2" and "LED3"
};

struct PlungerRow {
  std::string title, locator, type;  // types are "Joint3" and "Joint4"
};

struct SensorRow {
  std::string title, locator;
  SensorKind kind = SensorKind::kRaw;
  int index = -1;            // index of its element in the sensor vector
  int32_t touch_limit = -1;  // a value above this counts as touched; -1: not a touch sensor
};

struct CameraRow {
  std::string locator;
  int width = 0, height = 0;  // size of the largest layer, in pixels
  int32_t fov_urad = 0;       // field of view from left to right
};

struct PostureRow {
  std::string name;
  std::vector<int32_t> urad;  // angles in the order of the joints, inside the software limits
};

struct RobotTables {
  std::string design;
  std::vector<JointRow> joints;
  std::vector<LightRow> leds;
  std::vector<PlungerRow> plungers;
  std::vector<SensorRow> sensors;  // all sensors but those of joints
  int sensor_elements = 0;         // number of elements of the sensor vector, including those of
                                   // joints
  CameraRow camera;
  std::vector<PostureRow> postures;
  int32_t min_acceleration_cdeg = 0, default_acceleration_cdeg = 0, max_acceleration_cdeg = 0;
};

RobotTables TablesOf(const RobotModel& model);

}  // namespace openr_host::genmodel
