// The shapes from which pictures of a robot are made: rounded boxes that are fixed to the parts of
// the robot.
#pragma once

#include <Eigen/Geometry>
#include <optional>
#include <string>
#include <vector>

#include "openr/render/scene.h"
#include "virtualrobot/model/robot_model.h"
#include "virtualrobot/worlds/world.h"

namespace openr_host {

// A shape that is fixed to the part number `body` of a robot.
struct RobotShape {
  int body = 0;  // index of RobotModel::bodies
  // The shape; its pose `shape.X_WS` is the pose in the part, not in the world.  For an ear, it is
  // the pose when the ear's angle is 0. For a light, the colour is the colour of the light when it
  // is off.
  render::Shape shape;
  int led = -1;           // for a light: index of RobotModel::leds, otherwise -1
  render::Colour glow;    // for a light: its colour when it is on
  render::Colour glow_b;  // for a light of the ERS-7's face: its colour in mode B
  int ear = -1;           // for an ear (plunger): index of RobotModel::plungers, otherwise -1
  // For an ear: a point of the axis about which the ear turns, in the coordinates of the part.  The
  // direction of the axis is -y.
  Eigen::Vector3d pivot{0, 0, 0};
  std::string touch;  // the short name of the touch sensor under the shape; "": none
};

// Returns the shapes of a robot.
std::vector<RobotShape> ShapesOfRobot(const RobotModel& model);

// Returns the pose of a shape in its part.  For an ear, it is the pose when the ear has turned
// by `angle_rad`.  Other shapes do not move in their part.
Eigen::Isometry3d PlaceInPart(const RobotShape& shape, double angle_rad);

// Returns the shapes of the things in `world`, with their poses in the world.  Paint, which is a
// coloured area of the floor, becomes a thin plate.  Each plate lies a little higher than the
// plates of the paint before it in the world file, so that it covers them.
std::vector<render::Shape> ShapesOfWorld(const World& world);

// Returns the colour of the floor; nullopt if the world file gives no colour.
std::optional<render::Colour> FloorColour(const World& world);

}  // namespace openr_host
