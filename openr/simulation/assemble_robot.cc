#include "openr/simulation/assemble_robot.h"

#include <stdexcept>
#include <utility>

#include "runtime/base/assert.h"
#include "runtime/core/system.h"
#include "virtualrobot/battery.h"

namespace openr_host {

std::unique_ptr<Body> MakeBody(const std::string& kind, const RobotModel& model,
                               const World& world) {
  if (kind == "ode") return MakeOdeBody(model, world);
  if (kind == "ideal") return MakeIdealBody(model, world);
  return nullptr;
}

VirtualRobotOptions DevicesWithBattery(const std::string& battery) {
  VirtualRobotOptions devices;
  const std::string problem = ParseBattery(battery, &devices.battery);
  if (!problem.empty()) throw std::runtime_error("battery: " + problem);
  return devices;
}

// The order of these calls must not change: objects get their numbers in this order, and the
// numbers decide the order of messages.
AssembledRobot AssembleRobot(System* system, const RobotModel& model, RobotEquipment parts) {
  ASSERT(parts.make_network != nullptr);
  AssembledRobot robot;
  robot.number = system->AddRobot(model.design, std::move(parts.stick));
  if (parts.body != nullptr) {
    robot.virtual_robot = AddVirtualRobot(system, robot.number, model, std::move(parts.body),
                                          std::move(parts.devices));
  }
  robot.ip_stack =
      AddIpStack(system, robot.number, parts.make_network(robot.number), std::move(parts.ip_stack));
  return robot;
}

}  // namespace openr_host
