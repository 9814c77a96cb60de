#include "virtualrobot/robot/shared_frame.h"

#include "runtime/core/system.h"
#include "virtualrobot/robot/robot_parts.h"

namespace openr_host {

void SharedFrame::End(int64_t now_us) {
  // Compares numbers of frames and not times, because the messages that end one frame may reach the
  // robots some microseconds apart.
  const int64_t frame = now_us / robots_.front()->system.frame_us();
  if (frame == ended_frame_) return;
  ended_frame_ = frame;
  for (RobotParts* const robot : robots_) {
    robot->hands.DoFrame();
    robot->faults.DoFrame();
    // Gives no motor power to a robot that is off for good, because such a robot runs no more
    // frames and nothing else switches its motors off.
    const bool is_on = !robot->system.robot(robot->robot_index).powered_off;
    robot->body->SetCommands(robot->devices.Commands(is_on && robot->power.motor_power()));
  }
  for (RobotParts* const robot : robots_) robot->body->Advance();
}

}  // namespace openr_host
