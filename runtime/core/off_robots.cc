#include "runtime/core/off_robots.h"

#include <algorithm>

#include "runtime/base/assert.h"
#include "runtime/base/hasher.h"
#include "runtime/core/object_manager.h"
#include "runtime/core/robot_services.h"
#include "runtime/core/system.h"

namespace openr_host {

void OffRobots::Add(int robot, int64_t boot_us) {
  const int64_t frame_us = system_->frame_us();
  ASSERT(boot_us > system_->now_us(), "robot {} boots at {} us", robot, boot_us);
  // A robot that is off has frames, too (DoDue()).  The first of them ends at the next frame
  // boundary.
  robots_[robot] = {(system_->now_us() / frame_us + 1) * frame_us, boot_us};
}

int64_t OffRobots::BootUs(int robot) const {
  const auto found = robots_.find(robot);
  ASSERT(found != robots_.end(), "robot {} is not off, or stays off", robot);
  return found->second.boot_us;
}

bool OffRobots::Remove(int robot) { return robots_.erase(robot) > 0; }

int64_t OffRobots::NextUs() const {
  int64_t next_us = INT64_MAX;
  for (const auto& [robot, times] : robots_) next_us = std::min(next_us, times.frame_us);
  return next_us;
}

void OffRobots::DoDue() {
  for (auto& [robot, times] : robots_) {
    if (times.frame_us > system_->now_us()) continue;
    system_->robot(robot).services->RunFrameWhileOff();
    times.frame_us += system_->frame_us();
    if (times.boot_us > system_->now_us()) continue;
    // Lets no further frame of the robot end while it is off, because the boot of the robot is
    // posted now, and the object manager will boot the robot.
    times.frame_us = INT64_MAX;
    system_->manager().PostBootAgain(robot);
  }
}

void OffRobots::HashState(Hasher* hasher) const {
  for (const auto& [robot, times] : robots_) {
    hasher->Add(robot);
    hasher->Add(times.boot_us);
  }
}

}  // namespace openr_host
