#include "openr/simulation/assemble_robot.h"

#include <stdexcept>
#include <utility>

#include "runtime/base/assert.h"
#include "runtime/core/system.h"
#include "virtualrobot/power/battery.h"

namespace openr_host {

std::unique_ptr<Body> MakeBody(const std::string& kind, const RobotModel& model,
                               const World& world) {
  const StartPlace start = StartOf(world, 0);
  if (kind == "ode") return MakeOdeBody(model, world, start);
  if (kind == "ideal") return MakeIdealBody(model, world, start);
  return nullptr;
}

VirtualRobotOptions DevicesWithBattery(const std::string& battery) {
  VirtualRobotOptions devices;
  const std::string problem = ParseBattery(battery, &devices.battery);
  if (!problem.empty()) throw std::runtime_error("battery: " + problem);
  return devices;
}

bool IsImageFolder(const std::string& images) {
  return images != kImagesOfWorld && images != kImagesOfPattern;
}

std::unique_ptr<ImageSource> OpenImages(const std::string& images) {
  if (images == kImagesOfWorld) return nullptr;
  if (images == kImagesOfPattern) return std::make_unique<TestPattern>();
  return OpenImageFolder(images);
}

// The order of the calls in AssembleRobot() must not change: objects get their numbers in this
// order, and the numbers decide the order of messages.
AssembledRobot AssembleRobot(System* system, const RobotModel& model, RobotEquipment parts) {
  ASSERT(parts.make_network != nullptr);
  AssembledRobot robot;
  robot.number = system->AddRobot(model.design, std::move(parts.stick));
  if (parts.body != nullptr) {
    robot.virtual_robot = AddVirtualRobot(system, robot.number, model, std::move(parts.body),
                                          std::move(parts.devices));
  }
  robot.network = parts.make_network(robot.number);
  robot.ip_stack_options = std::move(parts.ip_stack);
  robot.ip_stack = AddIpStack(system, robot.number, robot.network, robot.ip_stack_options);
  return robot;
}

void AddSystemObjectsAgain(System* system, AssembledRobot* robot) {
  if (robot->virtual_robot != nullptr) AddSystemObjects(robot->virtual_robot);
  robot->ip_stack = AddIpStack(system, robot->number, robot->network, robot->ip_stack_options);
}

}  // namespace openr_host
