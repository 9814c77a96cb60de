// Vectors and rotations of ODE as those of Eigen.
#pragma once

#include <ode/ode.h>

#include <Eigen/Core>

namespace openr_host {

inline Eigen::Vector3d ToEigen(const dReal* v) { return {v[0], v[1], v[2]}; }

// ODE's matrices have rows of four numbers; the last one of a row is not used.
inline Eigen::Matrix3d RotationOf(dBodyID body) {
  const dReal* r = dBodyGetRotation(body);
  Eigen::Matrix3d R;
  R << r[0], r[1], r[2], r[4], r[5], r[6], r[8], r[9], r[10];
  return R;
}

}  // namespace openr_host
