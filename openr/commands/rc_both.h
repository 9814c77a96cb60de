// The actions of `openr rc` for two robots at once.
#pragma once

#include "openr/commands/rc_actions.h"

namespace openr_host {

// Connects to both robots, flags.address and flags.with, then carries out `action` at both at the
// same time.  Returns the exit code.  Throws what remote::Connection throws.
int PerformAtBoth(const RcFlags& flags, const RcAction& action);

// Lets the robot flags.address follow the robot flags.with, until Ctrl-C or flags.count reports.
int FollowRobot(const RcFlags& flags);

}  // namespace openr_host
