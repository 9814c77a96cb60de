// Matrices from world coordinates to those of OpenGL, which clips at -1 and 1.
#pragma once

#include <Eigen/Core>

#include "openr/render/scene.h"

namespace openr_host::render {

// Returns a perspective view; `aspect` is width divided by height of the picture.
Eigen::Matrix4f CameraMatrix(const Camera& camera, double aspect);

// Returns a view for parallel light from the direction `to_light` (a unit vector) on a square of 2
// * half_m around `target_W`.
Eigen::Matrix4f LightMatrix(const Eigen::Vector3d& target_W, const Eigen::Vector3d& to_light,
                            double half_m);

}  // namespace openr_host::render
