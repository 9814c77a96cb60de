#include "virtualrobot/shared_frame.h"

#include "virtualrobot/robot_parts.h"

namespace openr_host {

void SharedFrame::End(int64_t now_us) {
  if (now_us == ended_us_) return;
  ended_us_ = now_us;
  for (RobotParts* const robot : robots_) {
    robot->hands.DoFrame();
    robot->faults.DoFrame();
    robot->body->SetCommands(robot->devices.Commands(robot->power.motor_power()));
  }
  for (RobotParts* const robot : robots_) robot->body->Advance();
}

}  // namespace openr_host
