// Measures the angle and the speed of a joint on the two ODE bodies that the joint connects.
#pragma once

#include "virtualrobot/model/robot_model.h"

struct dxBody;  // ODE's rigid body

namespace openr_host {

// The axis about which a joint turns: coordinate axis `k` of the parent (0, 1, 2), in direction
// `sign` (+1, -1).
struct HingeAxis {
  int k = 0;
  double sign = 1;
};

// Returns the axis of `joint`.  REQUIRES: joint.axis is a coordinate axis, which LoadRobotModel()
// checks.
HingeAxis HingeAxisOf(const JointModel& joint);

// Returns the rotation of `child` against `parent` about `axis`, in [-pi, pi] rad.
double MeasureAngle(const HingeAxis& axis, dxBody* parent, dxBody* child);

// Returns the rate of change of the angle that MeasureAngle() measures, in rad/s.
double MeasureSpeed(const HingeAxis& axis, dxBody* parent, dxBody* child);

}  // namespace openr_host
