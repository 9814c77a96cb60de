#include "virtualrobot/base/rotation.h"

#include <cmath>

#include "virtualrobot/base/det_math.h"

namespace openr_host {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

}  // namespace

Matrix3d AxisRotation(const Vector3d& axis, double angle_rad) {
  const double s = DetSin(angle_rad), c = DetCos(angle_rad);
  const double x = axis.x(), y = axis.y(), z = axis.z(), v = 1 - c;
  Matrix3d R;
  R << x * x * v + c, x * y * v - z * s, x * z * v + y * s,  //
      x * y * v + z * s, y * y * v + c, y * z * v - x * s,   //
      x * z * v - y * s, y * z * v + x * s, z * z * v + c;
  return R;
}

Matrix3d RotationFromRpy(const Vector3d& rpy_rad) {
  return AxisRotation(Vector3d::UnitZ(), rpy_rad.z()) *
         AxisRotation(Vector3d::UnitY(), rpy_rad.y()) *
         AxisRotation(Vector3d::UnitX(), rpy_rad.x());
}

Vector3d RpyOf(const Matrix3d& R) {
  const double cp = std::sqrt(R(0, 0) * R(0, 0) + R(1, 0) * R(1, 0));
  return {DetAtan2(R(2, 1), R(2, 2)), DetAtan2(-R(2, 0), cp), DetAtan2(R(1, 0), R(0, 0))};
}

}  // namespace openr_host
