// JointCommands, which finds the requests for what a controller has changed.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "Messages.h"
#include "openr/remote/connection.h"

namespace openr_host {

// A request to the robot, and words for it in messages.
struct RobotCommand {
  openr::remote::Call call;
  std::string what;  // "a position of neck_pan"
  int joint = -1;    // of a position; -1: no position
};

// Compares the buffer of a controller with what was sent before.  Values that have not changed
// since are not sent again, so a command that another client has given meanwhile stays (Hohl
// 2004, 4.2.3). They are compared in the units of the protocol: 0.01 degree and so on.
class JointCommands {
 public:
  // Before the first command a joint counts as having no position, its largest speed and the
  // default acceleration, as for JointMover (Messages.h).
  explicit JointCommands(const RobotConstants* robot);

  // Returns the requests that bring the robot to `now`, and takes them for sent.  The order is that
  // of Hohl 2004, 4.2.3: positions, then speeds, then accelerations; motors are switched with the
  // positions.  While a motion plays (`is_playing`), the robot refuses positions: these are kept
  // and returned by a later call.
  std::vector<RobotCommand> Changes(const BatchMoverCommand& now, bool is_playing);

  // Takes the position of a joint for not sent, because the robot has refused it.
  void Forget(int joint) { sent_[static_cast<size_t>(joint)].position.reset(); }

 private:
  struct Sent {
    std::optional<Sint32> position;  // 0.01 degree
    Sint32 speed;
    Sint32 acceleration;
    bool is_off = false;
  };

  void AddPosition(int joint, const BatchJoint& now, bool is_playing,
                   std::vector<RobotCommand>* commands);

  const RobotConstants* const robot_;
  std::vector<Sent> sent_;
};

}  // namespace openr_host
