// The hash of a picture that a camera takes of a world, for golden.txt.
#pragma once

#include <cstdio>
#include <stdexcept>
#include <string>

#include "runtime/base/hasher.h"
#include "virtualrobot/base/det_math.h"
#include "virtualrobot/base/rotation.h"
#include "virtualrobot/camera/rendered_world.h"

namespace openr_host {

// Draws the world of a file as the camera of an ERS-210 sees it from `place`, which is a text such
// as "0.1,0,0.2,0,10,0": the place of the lens in m, and roll, pitch and yaw in degrees.
inline Picture PictureOf(const std::string& world_file, const std::string& place) {
  double x = 0, y = 0, z = 0, roll = 0, pitch = 0, yaw = 0;
  if (std::sscanf(place.c_str(), "%lf,%lf,%lf,%lf,%lf,%lf", &x, &y, &z, &roll, &pitch, &yaw) != 6)
    throw std::runtime_error("'" + place + "' is no place such as 0.1,0,0.2,0,10,0");
  CameraShot shot;
  shot.X_WC.linear() = RotationFromRpy({Radians(roll), Radians(pitch), Radians(yaw)});
  shot.X_WC.translation() = Eigen::Vector3d(x, y, z);
  shot.fov_h_rad = Radians(57.6);
  shot.fov_v_rad = Radians(47.8);
  Picture picture{352, 288, std::vector<uint8_t>(size_t{352} * 288 * 3)};
  const World world = LoadWorld(world_file);
  Canvas canvas;
  DrawWorld(shot, world, world.things, &canvas, &picture);
  return picture;
}

inline uint64_t HashOfPicture(const std::string& world_file, const std::string& place) {
  const Picture picture = PictureOf(world_file, place);
  return HashBytes(picture.rgb.data(), picture.rgb.size());
}

}  // namespace openr_host
