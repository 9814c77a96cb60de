// Observation: values of a run that a program reads again and again, as numbers in one row.
#pragma once

#include <functional>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "openr/explore/quantity.h"

namespace openr_host {

// A value of a run, and its full name, such as "robots[0].joint.LF_j1".
struct ReadValue {
  std::string name;
  Quantity read;
};

// Returns the values with the name `name`: the name of a quantity (docs/exploring.md), where
// "robots[0]." may be left out, or one of these names of a robot's values:
//   target.JOINT, measured.JOINT            set point and measured angle, in degrees
//   speed.JOINT, drive.JOINT                speed in degrees/s, drive of the motor
//   sensor.NAME                             a sensor by its short name, such as sensor.chin
//   paw.LEG                                 1 if the paw touches something, such as paw.LF
//   vx_m_s, vy_m_s, vz_m_s                  velocity of the base in the world
//   wx_deg_s, wy_deg_s, wz_deg_s            angular velocity of the base about its own axes
// or a group: joints, targets, measured, speeds, drives, sensors, paws.  A group has all values of
// one kind of one robot, in the order of the model.  Throws std::runtime_error if no value has the
// name `name`.
std::vector<ReadValue> FindValues(const std::string& name, const RunView& view);

class Observation {
 public:
  // Chooses the values that are read from now on.  If a name is not known or names a text, throws
  // std::runtime_error and keeps the old values.
  void Choose(const std::vector<std::string>& names, const RunView& view);

  const std::vector<ReadValue>& values() const { return values_; }

  // Returns the present values of the quantities that Choose() has chosen, as numbers of the type
  // double, one after the other.
  std::string Bytes(const RunView& view) const;

 private:
  std::vector<ReadValue> values_;
};

}  // namespace openr_host
