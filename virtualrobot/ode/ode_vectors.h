// Converts vectors and rotations of ODE to the types of Eigen.
#pragma once

#include <ode/ode.h>

#include <Eigen/Core>

namespace openr_host {

inline Eigen::Vector3d ToEigen(const dReal* v) { return {v[0], v[1], v[2]}; }

// Returns the rotation of `body`.  A row of an ODE matrix has four numbers, the last of which is
// not used.
inline Eigen::Matrix3d RotationOf(dBodyID body) {
  const dReal* r = dBodyGetRotation(body);
  Eigen::Matrix3d R;
  R << r[0], r[1], r[2], r[4], r[5], r[6], r[8], r[9], r[10];
  return R;
}

}  // namespace openr_host
