// Stands a robot up on its body with physics and measures how well it stands.
#pragma once

#include <string>
#include <vector>

#include "virtualrobot/model/robot_model.h"

namespace openr_host {

// Limits of a model that stands well (docs/body.md).
inline constexpr double kPitchToleranceDeg = 1, kHeightToleranceMm = 3;
inline constexpr double kStaticErrorMaxDeg = 2, kDriftMaxMm = 10, kDriftMaxDeg = 3;

struct ModelCheck {
  double total_mass_g = 0;
  // 2 s after standing up: the largest distance of a joint from its set point, and the base frame's
  // attitude and height over the floor.
  double static_error_deg_max = 0;
  double roll_deg = 0, pitch_deg = 0, height_mm = 0;
  int paws = 0;  // number of paws on the floor
  // Pitch and height of a stiff robot with the same set points, from kinematics alone.
  double stiff_pitch_deg = 0, stiff_height_mm = 0;
  // Way and largest change of roll, pitch or yaw in the 60 s that follow.
  double drift_60s_mm = 0, drift_60s_deg = 0;
  std::vector<std::string> problems;  // what is outside of the limits above
};

// Throws std::runtime_error if the model has no body with physics.
ModelCheck CheckModel(const RobotModel& model);

}  // namespace openr_host
