// Measures the servos and the distance sensor of a robot model, for docs/calibration.md.
#pragma once

#include <string>
#include <vector>

#include "virtualrobot/model/robot_model.h"

namespace openr_host {

// The response of a joint to a step of its set point, sampled at the end of each frame of 8 ms.
struct StepResponse {
  std::string joint;
  double from_deg = 0, to_deg = 0;
  std::vector<double> times_ms, commanded_deg, measured_deg;
  double rise_ms = 0;         // time until the joint has moved 90 % of the way; -1: it moved less
  double overshoot_deg = 0;   // how far the joint went beyond its new set point
  double end_error_deg = 0;   // distance from the set point at the end of the measurement
  double current_ma_max = 0;  // highest current that the robot draws from its battery
};

// Makes a robot stand in the air, as if a hand held it.  Then moves one joint after the other by a
// step of at most `step_deg` towards the middle of its range.  Returns the response of each joint.
std::vector<StepResponse> MeasureSteps(const RobotModel& model, double step_deg);

// Readings of the distance sensor in front of a wall: least, mean and largest of 200 values.
struct DistanceReading {
  double distance_mm = 0;  // distance of the wall, along the ray of the sensor
  double reflectance = 1;
  double min_mm = 0, mean_mm = 0, max_mm = 0;
};

// Measures the distance to a wall 100, 150 ... 1000 mm in front of the first distance sensor of a
// standing robot.  Returns no readings if the model does not say where its distance sensors are on
// the body.
std::vector<DistanceReading> MeasureDistances(const RobotModel& model, double reflectance);

}  // namespace openr_host
