// Matrices from the world to what OpenGL clips at -1 and 1.
#pragma once

#include <Eigen/Core>

#include "openr/render/scene.h"

namespace openr_host::render {

// Perspective; `aspect` is width by height of the picture.
Eigen::Matrix4f CameraMatrix(const Camera& camera, double aspect);

// Parallel light from the direction `to_light` (unit vector) on a square of 2 * half_m round
// `target_W`.
Eigen::Matrix4f LightMatrix(const Eigen::Vector3d& target_W, const Eigen::Vector3d& to_light,
                            double half_m);

}  // namespace openr_host::render
