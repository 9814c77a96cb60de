// Angle and speed of a joint, measured on the two ODE bodies that the joint connects.
#pragma once

#include "virtualrobot/model/robot_model.h"

struct dxBody;  // ODE's rigid body

namespace openr_host {

// The coordinate axis of the parent about which a joint turns (0, 1, 2), and its direction (+1,
// -1).
struct HingeAxis {
  int k = 0;
  double sign = 1;
};

// REQUIRES: joint.axis is a coordinate axis, as models are checked to have it.
HingeAxis HingeAxisOf(const JointModel& joint);

// Rotation of `child` against `parent` about the axis, in [-pi, pi] rad.
double MeasureAngle(const HingeAxis& axis, dxBody* parent, dxBody* child);

// The rate of that angle, rad/s.
double MeasureSpeed(const HingeAxis& axis, dxBody* parent, dxBody* child);

}  // namespace openr_host
