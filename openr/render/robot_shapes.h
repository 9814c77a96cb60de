// The shapes of which pictures of a robot consist: rounded boxes that are fixed to its parts.
#pragma once

#include <Eigen/Geometry>
#include <string>
#include <vector>

#include "openr/render/scene.h"
#include "virtualrobot/model/robot_model.h"
#include "virtualrobot/world.h"

namespace openr_host {

// A shape that is fixed to part `body` of a robot.
struct RobotShape {
  int body = 0;  // index of RobotModel::bodies
  // Has the place in the part, not in the world, in X_WS.  An ear has the place for angle 0, and a
  // light has the colour that it has when it is off.
  render::Shape shape;
  int led = -1;                    // a light: index of RobotModel::leds
  render::Colour glow;             // of a light that is on
  int ear = -1;                    // an ear: index of RobotModel::plungers
  Eigen::Vector3d pivot{0, 0, 0};  // of an ear, in its part; the ear turns about -y
  std::string touch;  // short name of the sensor that feels when a person touches the shape
};

// Returns the shapes of a robot.
std::vector<RobotShape> ShapesOfRobot(const RobotModel& model);

// Returns where an ear is when its plunger has turned by `angle_rad`.  Any other shape does not
// move in its part, and has the same place for each angle.
Eigen::Isometry3d PlaceInPart(const RobotShape& shape, double angle_rad);

// Returns the shapes of the things in a world, with their places in the world.
std::vector<render::Shape> ShapesOfWorld(const World& world);

}  // namespace openr_host
