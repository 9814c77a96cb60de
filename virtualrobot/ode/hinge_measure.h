// Angle and speed of a joint, measured on the two ODE bodies it connects.
#pragma once

#include <ode/ode.h>

#include "virtualrobot/model/robot_model.h"

namespace openr_host {

// The coordinate axis of the parent a joint turns about (0, 1, 2), and which way (+1, -1).
struct HingeAxis {
  int k = 0;
  double sign = 1;
};

HingeAxis HingeAxisOf(const JointModel& joint);

// Rotation of `child` against `parent` about the axis, in [-pi, pi] rad.
double MeasureAngle(const HingeAxis& axis, dBodyID parent, dBodyID child);

// Its rate, rad/s.
double MeasureSpeed(const HingeAxis& axis, dBodyID parent, dBodyID child);

}  // namespace openr_host
