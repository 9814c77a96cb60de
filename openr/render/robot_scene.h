// Makes the scene of a robot in its world: the look of its bodies, lights and ears.
#pragma once

#include <Eigen/Geometry>
#include <string>
#include <string_view>
#include <vector>

#include "openr/render/scene.h"
#include "virtualrobot/model/robot_model.h"
#include "virtualrobot/world.h"

namespace openr_host {

// The data that decide how a robot looks at one instant.
struct RobotLook {
  Eigen::Isometry3d X_WB = Eigen::Isometry3d::Identity();
  std::vector<Eigen::Isometry3d> X_WL;  // order of RobotModel::bodies, as Body::BodyPoses()
  std::vector<bool> leds_on;            // order of RobotModel::leds; missing ones are off
  std::vector<double> plungers_rad;     // order of RobotModel::plungers; missing ones are 0
};

// The place of the camera, relative to the robot's position and heading.
enum class View { kSide, kFront, kTop, kIso, kFollow };

// Reads "side", "front", "top", "iso" or "follow"; returns false for other names.
bool ParseView(std::string_view name, View* view);

render::Scene MakeRobotScene(const RobotModel& model, const RobotLook& look, const World& world,
                             View view);

}  // namespace openr_host
