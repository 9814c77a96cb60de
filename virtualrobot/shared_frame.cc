#include "virtualrobot/shared_frame.h"

#include "runtime/core/system.h"
#include "virtualrobot/robot_parts.h"

namespace openr_host {

void SharedFrame::End(int64_t now_us) {
  // The number of the frame tells whether it has ended, because messages to many robots at one time
  // may come some microseconds apart.
  const int64_t frame = now_us / robots_.front()->system.frame_us();
  if (frame == ended_frame_) return;
  ended_frame_ = frame;
  for (RobotParts* const robot : robots_) {
    robot->hands.DoFrame();
    robot->faults.DoFrame();
    // A robot that is off for good has no frames of its own any more, and nobody has switched off
    // its motors.
    const bool is_on = !robot->system.robot(robot->robot_index).powered_off;
    robot->body->SetCommands(robot->devices.Commands(is_on && robot->power.motor_power()));
  }
  for (RobotParts* const robot : robots_) robot->body->Advance();
}

}  // namespace openr_host
