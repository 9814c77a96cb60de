#include "virtualrobot/ode/hinge_measure.h"

#include <ode/ode.h>

#include <cmath>

#include "runtime/base/assert.h"
#include "virtualrobot/det_math.h"

namespace openr_host {

HingeAxis HingeAxisOf(const JointModel& joint) {
  const int k = joint.axis.x() != 0 ? 0 : joint.axis.y() != 0 ? 1 : 2;
  ASSERT(std::fabs(joint.axis[k]) == 1, "the axis of {} is not a coordinate axis", joint.name);
  return {k, joint.axis[k]};
}

// Computes the rotation parent^-1 child as a quaternion.  If w is its real part and s its part
// along the axis, the angle is twice the angle of the point (w, s).  ODE's own
// dJointGetHingeAngle() is not used, because it takes atan2 of libm, whose bits depend on the
// processor.
double MeasureAngle(const HingeAxis& axis, dBodyID parent, dBodyID child) {
  const dReal* p = dBodyGetQuaternion(parent);
  const dReal* c = dBodyGetQuaternion(child);
  const int x = 1 + axis.k, y = 1 + (axis.k + 1) % 3, z = 1 + (axis.k + 2) % 3;
  double w = p[0] * c[0] + p[1] * c[1] + p[2] * c[2] + p[3] * c[3];
  double s = axis.sign * ((p[0] * c[x] - p[x] * c[0]) - (p[y] * c[z] - p[z] * c[y]));
  if (w < 0) w = -w, s = -s;  // q and -q are the same rotation; w >= 0 gives [-pi, pi]
  return 2 * DetAtan2(s, w);
}

// Computes the difference of the two angular velocities along the axis, which is column k of the
// parent's rotation.
double MeasureSpeed(const HingeAxis& axis, dBodyID parent, dBodyID child) {
  const dReal* R = dBodyGetRotation(parent);
  const dReal* wp = dBodyGetAngularVel(parent);
  const dReal* wc = dBodyGetAngularVel(child);
  const int k = axis.k;
  return axis.sign *
         (R[k] * (wc[0] - wp[0]) + R[4 + k] * (wc[1] - wp[1]) + R[8 + k] * (wc[2] - wp[2]));
}

}  // namespace openr_host
