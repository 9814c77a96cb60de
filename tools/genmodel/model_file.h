// What the objects need of a robot model file, as read; the only place of this tool
// that knows the file's field names.
//
// The files are virtualrobot/model/*.json: angles in degrees, speeds in degree/s, lists
// as {"source": ..., "rows": [...]}.  Here angles are micro-radians and hundredths of a
// degree, rounded to the nearest.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace openr_host::genmodel {

struct Joint {
  std::string name, title, locator;
  int32_t min_urad = 0, max_urad = 0;
  int32_t min_cdeg = 0, max_cdeg = 0;
  int32_t min_speed_cdeg = 0, max_speed_cdeg = 0;
  std::vector<int> gain;  // six: P, I, D, then their shifts
  int sensor = -1, mtn = -1;
};

struct Light {
  std::string title, locator, type;  // "LED2", "LED3"
};

struct Plunger {
  std::string title, locator, type;  // "Joint3", "Joint4"
};

struct Sensor {
  std::string title, locator, kind;  // "switch", "force", "distance", ...
  int index = -1;                    // in the sensor vector
  int32_t touch_limit = -1;          // touched above this; -1: not a touch sensor
};

struct Camera {
  std::string locator;
  int width = 0, height = 0;  // of its largest layer, pixels
  int32_t fov_urad = 0;       // from left to right
};

struct Posture {
  std::string name;
  std::vector<int32_t> urad;  // order of joints, inside the software limits
};

struct Model {
  std::string design;
  std::vector<Joint> joints;
  std::vector<Light> leds;
  std::vector<Plunger> plungers;
  std::vector<Sensor> sensors;  // joints left out
  int sensor_elements = 0;      // joints included
  Camera camera;
  std::vector<Posture> postures;
  int32_t min_acceleration_cdeg = 0, default_acceleration_cdeg = 0, max_acceleration_cdeg = 0;
};

// Throws std::runtime_error naming file and field.
Model ReadModel(const std::string& path);

}  // namespace openr_host::genmodel
