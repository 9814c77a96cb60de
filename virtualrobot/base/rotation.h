// Rotations as matrices, about one axis and by roll, pitch and yaw.
//
// The results have the same bits in every build, because the code uses det_math.h, and Eigen
// without vectorization.
#pragma once

#include <Eigen/Core>

namespace openr_host {

// Returns the rotation by `angle_rad` about the unit vector `axis`.
Eigen::Matrix3d AxisRotation(const Eigen::Vector3d& axis, double angle_rad);

// Returns the rotation R_WB = Rz(yaw) Ry(pitch) Rx(roll).  `rpy_rad` has roll (about x), pitch
// (about y) and yaw (about z).  When the nose of a robot with the base frame B points down, pitch
// is positive.
Eigen::Matrix3d RotationFromRpy(const Eigen::Vector3d& rpy_rad);

// Returns roll, pitch and yaw of the rotation `R`.  For |pitch| < pi/2, this is the inverse of
// RotationFromRpy().
Eigen::Vector3d RpyOf(const Eigen::Matrix3d& R);

}  // namespace openr_host
