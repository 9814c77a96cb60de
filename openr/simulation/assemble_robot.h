// Assembles a simulated robot from its parts, in the same way for runs and for tests.
#pragma once

#include <functional>
#include <memory>
#include <string>

#include "runtime/ipstack/ip_stack.h"
#include "runtime/stick/memory_stick.h"
#include "virtualrobot/body/body.h"
#include "virtualrobot/virtual_robot.h"
#include "virtualrobot/worlds/world.h"

namespace openr_host {

class System;

// Returns the body of the kind `kind`: "ode" (a body with physics) or "ideal" (joints follow their
// commands exactly).  Returns null for any other kind.  The body is alone in `world`, at the
// world's first starting place.
std::unique_ptr<Body> MakeBody(const std::string& kind, const RobotModel& model,
                               const World& world);

// Returns the options of a robot's devices, with the battery that `battery` describes and without
// files for sound and pictures.  Throws std::runtime_error if `battery` is wrong; see
// ParseBattery().
VirtualRobotOptions DevicesWithBattery(const std::string& battery);

// Values of the flag `--images`, which chooses what the camera of a robot sees: the robot's world,
// or the test pattern.  Any other value is a folder of pictures.
inline constexpr char kImagesOfWorld[] = "world", kImagesOfPattern[] = "pattern";
bool IsImageFolder(const std::string& images);

// Returns the source of the pictures for a camera, as `images` (a value of --images) names it.
// Returns null if `images` names the world, because null in VirtualRobotOptions::camera means the
// world.  Throws std::runtime_error if `images` is a folder that cannot be used.
std::unique_ptr<ImageSource> OpenImages(const std::string& images);

struct RobotEquipment {
  std::shared_ptr<MemoryStick> stick;  // the Memory Stick; null: the robot has no stick
  std::unique_ptr<Body> body;  // the body; null: the robot has no body and no OVirtualRobotComm
  VirtualRobotOptions devices;
  // A function that makes the network of the robot whose number in the System is `robot`.
  std::function<std::unique_ptr<Network>(int robot)> make_network;
  IpStackOptions ip_stack;
};

struct AssembledRobot {
  int number = 0;                    // the robot's number in the System
  VirtualRobot* virtual_robot = {};  // devices of the robot; null: the robot has no body
  IpStack* ip_stack = {};
  std::shared_ptr<Network> network;
  IpStackOptions ip_stack_options;
};

// Adds a robot with the parts `parts` to `system`, without the objects of its Memory Stick, which
// LoadStick() adds later.  `model` must outlive `system`.
AssembledRobot AssembleRobot(System* system, const RobotModel& model, RobotEquipment parts);

// Adds the system objects of `robot` again, because the robot boots after a shutdown.  Sets
// robot->ip_stack.  REQUIRES: called in Robot::load_again.
void AddSystemObjectsAgain(System* system, AssembledRobot* robot);

}  // namespace openr_host
