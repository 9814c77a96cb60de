#include "openr/render/view_matrices.h"

#include <cmath>

namespace openr_host::render {
namespace {

// The nearest distance at which surfaces are drawn, as a fraction of the distance from the camera
// to its target.  With a smaller fraction, the depths in a wide view would differ too little to
// tell paint from the floor.
constexpr double kNearShare = 0.02;
constexpr double kFarM = 30;

// Returns the matrix that puts `eye` at the origin and `target` on the negative z axis.  x is to
// the right, y is up.
Eigen::Matrix4d LookAt(const Eigen::Vector3d& eye, const Eigen::Vector3d& target,
                       const Eigen::Vector3d& up) {
  const Eigen::Vector3d z = (eye - target).normalized();
  const Eigen::Vector3d x = up.cross(z).normalized();
  const Eigen::Vector3d y = z.cross(x);
  Eigen::Matrix4d result = Eigen::Matrix4d::Identity();
  result.block<1, 3>(0, 0) = x.transpose();
  result.block<1, 3>(1, 0) = y.transpose();
  result.block<1, 3>(2, 0) = z.transpose();
  result.block<3, 1>(0, 3) = -result.block<3, 3>(0, 0) * eye;
  return result;
}

}  // namespace

Eigen::Matrix4f CameraMatrix(const Camera& camera, double aspect) {
  const double near_m = kNearShare * (camera.p_W - camera.target_W).norm();
  const double f = 1 / std::tan(camera.fov_rad / 2);
  Eigen::Matrix4d lens = Eigen::Matrix4d::Zero();
  lens(0, 0) = f / aspect;
  lens(1, 1) = f;
  lens(2, 2) = (kFarM + near_m) / (near_m - kFarM);
  lens(2, 3) = 2 * kFarM * near_m / (near_m - kFarM);
  lens(3, 2) = -1;
  return (lens * LookAt(camera.p_W, camera.target_W, camera.up)).cast<float>();
}

Eigen::Matrix4f LightMatrix(const Eigen::Vector3d& target_W, const Eigen::Vector3d& to_light,
                            double half_m) {
  const double distance = 4 * half_m;
  // Chooses an upward direction that is not parallel to the light, because LookAt() cannot use an
  // upward direction that is parallel to the line of sight.
  const Eigen::Vector3d up =
      std::abs(to_light.x()) < 0.9 ? Eigen::Vector3d::UnitX() : Eigen::Vector3d::UnitY();
  Eigen::Matrix4d box = Eigen::Matrix4d::Identity();
  box(0, 0) = box(1, 1) = 1 / half_m;
  // Converts a distance from the light to the depth of OpenGL, which goes from -1 at the near end
  // of the drawn space to 1 at its far end.  The near end is at the light.  The far end is
  // `distance` behind the target, and so 2 * `distance` from the light.  So the depth changes by 1
  // for each `distance`.  The sign is negative because the view looks along the negative z axis.
  box(2, 2) = -1 / distance;
  box(2, 3) = -1;
  return (box * LookAt(target_W + distance * to_light, target_W, up)).cast<float>();
}

}  // namespace openr_host::render
