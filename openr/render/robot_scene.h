// Makes the scene for a picture of a robot in its world: shapes for its parts, lights and ears.
#pragma once

#include <Eigen/Geometry>
#include <string>
#include <string_view>
#include <vector>

#include "openr/render/scene.h"
#include "virtualrobot/model/robot_model.h"
#include "virtualrobot/worlds/world.h"

namespace openr_host {

class VirtualRobot;

// The state of a robot that can be seen: its posture, lights and ears.
struct RobotLook {
  Eigen::Isometry3d X_WB = Eigen::Isometry3d::Identity();
  std::vector<Eigen::Isometry3d> X_WL;  // poses of the bodies, in the order of Body::BodyPoses()
  // Brightness of each light, 0 to 1, in the order of RobotModel::leds; lights that the list lacks
  // are off.
  std::vector<double> leds;
  bool is_face_in_mode_b = false;  // true: the lights of the face show their colours of mode B
  // Angles of the ears (plungers), in the order of RobotModel::plungers; angles that the list lacks
  // are 0.
  std::vector<double> plungers_rad;
};

// Returns the present posture, lights and ears of `robot`.
RobotLook LookOf(const VirtualRobot& robot);

// The place of the camera relative to the robot: at its right side, in front of it, above it, in
// front of it to the right and higher (iso), or behind it and higher (follow).  The camera moves
// and turns with the robot.  kWorld shows all robots and things from above the right side of the
// first robot's start.  kCamera is the view of the robot's own camera, for which
// MakeRobotScene() makes no scene.
enum class View { kSide, kFront, kTop, kIso, kFollow, kWorld, kCamera };

// Sets `view` to the view "side", "front", "top", "iso", "follow", "world" or "camera".  Returns
// false for other names.
bool ParseView(std::string_view name, View* view);

// Makes the scene for a picture of robots of one model in their world.  REQUIRES: `view` is not
// View::kCamera.
render::Scene MakeRobotScene(const RobotModel& model, const std::vector<RobotLook>& looks,
                             const World& world, View view);

}  // namespace openr_host
