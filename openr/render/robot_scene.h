// The picture of a robot in its world: what its bodies, lights and ears look like from outside.
#pragma once

#include <Eigen/Geometry>
#include <string>
#include <string_view>
#include <vector>

#include "openr/render/scene.h"
#include "virtualrobot/model/robot_model.h"
#include "virtualrobot/world.h"

namespace openr_host {

// A robot at one instant.
struct RobotLook {
  Eigen::Isometry3d X_WB = Eigen::Isometry3d::Identity();
  std::vector<Eigen::Isometry3d> X_WL;  // order of RobotModel::bodies, as Body::BodyPoses()
  std::vector<bool> leds_on;            // order of RobotModel::leds; missing ones are off
  std::vector<double> plungers_rad;     // order of RobotModel::plungers; missing ones are 0
};

// Where to look from, relative to the robot's place and heading.
enum class View { kSide, kFront, kTop, kIso, kFollow };

// "side", "front", "top", "iso", "follow"; false for any other name.
bool ParseView(std::string_view name, View* view);

render::Scene MakeRobotScene(const RobotModel& model, const RobotLook& look, const World& world,
                             View view);

}  // namespace openr_host
