// The actions of `openr rc` for two robots at once.
#pragma once

#include "openr/commands/rc_actions.h"

namespace openr_host {

// Connects to the two robots whose addresses are flags.address and flags.with.  Then carries out
// `action` at both at the same time.  Returns the exit code.  Throws the exceptions of
// remote::Connection.
int PerformAtBoth(const RcFlags& flags, const RcAction& action);

// Makes the robot flags.address follow the robot flags.with.  Ends at Ctrl-C or after flags.count
// reports.  Returns the exit code.
int FollowRobot(const RcFlags& flags);

}  // namespace openr_host
