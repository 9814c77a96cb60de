#include "virtualrobot/ode/hinge_measure.h"

#include "virtualrobot/det_math.h"

namespace openr_host {

HingeAxis HingeAxisOf(const JointModel& joint) {
  const int k = joint.axis.x() != 0 ? 0 : joint.axis.y() != 0 ? 1 : 2;
  return {k, joint.axis[k]};
}

// From the quaternions: twice the angle of (w, part along the axis) of parent^-1 child.
// ODE's own dJointGetHingeAngle() takes atan2 of libm, whose bits depend on the CPU.
double MeasureAngle(const HingeAxis& axis, dBodyID parent, dBodyID child) {
  const dReal* p = dBodyGetQuaternion(parent);
  const dReal* c = dBodyGetQuaternion(child);
  const int x = 1 + axis.k, y = 1 + (axis.k + 1) % 3, z = 1 + (axis.k + 2) % 3;
  double w = p[0] * c[0] + p[1] * c[1] + p[2] * c[2] + p[3] * c[3];
  double s = axis.sign * ((p[0] * c[x] - p[x] * c[0]) - (p[y] * c[z] - p[z] * c[y]));
  if (w < 0) w = -w, s = -s;  // q and -q are one rotation: take the angle in [-pi, pi]
  return 2 * DetAtan2(s, w);
}

double MeasureSpeed(const HingeAxis& axis, dBodyID parent, dBodyID child) {
  const dReal* R = dBodyGetRotation(parent);
  const dReal* wp = dBodyGetAngularVel(parent);
  const dReal* wc = dBodyGetAngularVel(child);
  const int k = axis.k;
  return axis.sign *
         (R[k] * (wc[0] - wp[0]) + R[4 + k] * (wc[1] - wp[1]) + R[8 + k] * (wc[2] - wp[2]));
}

}  // namespace openr_host
