// Checks a robot model: lets the robot stand on its body with physics, and measures how well it
// stands.
#pragma once

#include <string>
#include <vector>

#include "virtualrobot/model/robot_model.h"

namespace openr_host {

// Limits for a robot that stands well (docs/body.md).  The tolerances are the largest differences
// of pitch and height from a robot with joints that do not give way.  The tolerance of the pitch
// holds for the roll, too.
inline constexpr double kPitchToleranceDeg = 1, kHeightToleranceMm = 3;
inline constexpr double kStaticErrorMaxDeg = 2, kDriftMaxMm = 10, kDriftMaxDeg = 3;

struct ModelCheck {
  double total_mass_g = 0;
  // Largest distance between the angle of a joint and its set point, 2 s after standing up.
  double static_error_deg_max = 0;
  // Attitude of the base frame and its height over the floor, 2 s after standing up.
  double roll_deg = 0, pitch_deg = 0, height_mm = 0;
  int paws = 0;  // number of paws that touch the floor
  // Pitch and height of a robot whose joints are exactly at the set points, computed from the
  // lengths of its parts alone.  The difference from pitch_deg and height_mm shows how far the
  // joints give way.
  double stiff_pitch_deg = 0, stiff_height_mm = 0;
  // Distance that the robot moves, and largest change of roll, pitch or yaw, from 2 s to 62 s after
  // standing up.
  double drift_60s_mm = 0, drift_60s_deg = 0;
  std::vector<std::string> problems;  // a text for each value outside of its limit
};

// Checks how well `model` stands.  Throws std::runtime_error if the model has no body with physics.
ModelCheck CheckModel(const RobotModel& model);

}  // namespace openr_host
