// Makes matrices that convert world coordinates to OpenGL's, which are -1 to 1 inside the picture.
#pragma once

#include <Eigen/Core>

#include "openr/render/scene.h"

namespace openr_host::render {

// Returns the matrix for the picture of `camera`, which has perspective.  `aspect` is the picture's
// width divided by its height.
Eigen::Matrix4f CameraMatrix(const Camera& camera, double aspect);

// Returns the matrix for the view from a distant light along its parallel rays.  `to_light` is a
// unit vector towards the light; the view is a square of 2 * half_m around `target_W`.
Eigen::Matrix4f LightMatrix(const Eigen::Vector3d& target_W, const Eigen::Vector3d& to_light,
                            double half_m);

}  // namespace openr_host::render
