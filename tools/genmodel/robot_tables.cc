#include "robot_tables.h"

#include <algorithm>
#include <cmath>

#include "virtualrobot/base/det_math.h"

namespace openr_host::genmodel {
namespace {

int32_t UradOf(double rad) { return static_cast<int32_t>(std::lround(rad * 1e6)); }
int32_t CdegOf(double rad) { return static_cast<int32_t>(std::lround(Degrees(rad) * 100)); }

// Rounds a limit down to hundredths: 120.625 degree/s becomes 12062, because 12063 would exceed the
// limit.
int32_t CdegBelow(double rad) {
  return static_cast<int32_t>(std::floor(Degrees(rad) * 100 + 1e-6));
}

JointRow RowOf(const JointModel& joint, const RobotModel& model) {
  JointRow row;
  row.name = joint.name;
  // Takes the title of the joint from its element of the sensor vector, which has one for every
  // joint.
  row.title = model.sensors.at(static_cast<size_t>(joint.sensor)).name;
  row.locator = joint.locator;
  row.min_urad = UradOf(joint.soft_rad.min);
  row.max_urad = UradOf(joint.soft_rad.max);
  row.min_cdeg = CdegOf(joint.soft_rad.min);
  row.max_cdeg = CdegOf(joint.soft_rad.max);
  row.min_speed_cdeg = CdegOf(joint.speed_rad_s.min);
  row.max_speed_cdeg = CdegBelow(joint.speed_rad_s.max);
  const PidGains& gains = joint.gains;
  row.gain = {gains.p, gains.i, gains.d, gains.p_shift, gains.i_shift, gains.d_shift};
  row.sensor = joint.sensor;
  row.mtn = joint.mtn;
  return row;
}

// Returns half of the upper limit of a head sensor, beyond which it counts as touched (Hohl 2004,
// 5.3.5).
int32_t TouchLimit(const Sensor& sensor) {
  if (sensor.kind == SensorKind::kSwitch) return 0;
  if (sensor.kind == SensorKind::kForce || sensor.kind == SensorKind::kRaw)
    return static_cast<int32_t>(sensor.max) / 2;
  return -1;
}

PostureRow RowOf(const Posture& posture, const std::vector<JointRow>& joints) {
  PostureRow row;
  row.name = posture.name;
  for (size_t j = 0; j < joints.size(); ++j) {
    row.urad.push_back(
        std::clamp(UradOf(posture.angles_rad[j]), joints[j].min_urad, joints[j].max_urad));
  }
  return row;
}

}  // namespace

RobotTables TablesOf(const RobotModel& model) {
  RobotTables tables;
  tables.design = model.design;
  for (const JointModel& joint : model.joints) tables.joints.push_back(RowOf(joint, model));
  for (const Led& led : model.leds) tables.leds.push_back({led.name, led.locator, led.type});
  for (const Plunger& plunger : model.plungers)
    tables.plungers.push_back({plunger.name, plunger.locator, plunger.type});
  for (const Sensor& sensor : model.sensors) {
    const int index = tables.sensor_elements++;
    if (sensor.kind == SensorKind::kJoint) continue;
    tables.sensors.push_back({sensor.name, sensor.locator, sensor.kind, index, TouchLimit(sensor)});
  }
  const Camera& camera = model.camera;
  // The largest picture that programs get, layer H, is half of the camera's picture.
  tables.camera = {camera.locator, camera.width_px / 2, camera.height_px / 2,
                   UradOf(camera.fov_h_rad)};
  for (const Posture& posture : model.postures)
    tables.postures.push_back(RowOf(posture, tables.joints));
  tables.min_acceleration_cdeg = CdegOf(model.accel_min_rad_s2);
  tables.default_acceleration_cdeg = CdegOf(model.accel_default_rad_s2);
  tables.max_acceleration_cdeg = CdegBelow(model.accel_max_rad_s2);
  return tables;
}

}  // namespace openr_host::genmodel
