// JointCommands, which converts the changes that a controller has made to requests to the robot.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "Messages.h"
#include "openr/remote/connection.h"

namespace openr_host {

// A request that is sent to the robot, and a text that describes this request in warnings to the
// user.
struct RobotCommand {
  openr::remote::Call call;
  std::string what;  // description of the request, such as "a position of neck_pan"
  int joint = -1;    // the joint whose position the request sets; -1: it sets something else
};

// Compares the commands that a controller wants with the values that were sent to the robot before.
// Unchanged values are not sent again, so a command that another client has given meanwhile stays
// (Hohl 2004, 4.2.3).  Values are compared in the units of the remote control, such as 0.01 degree.
class JointCommands {
 public:
  // Begins with the values that the object JointMover has before its first command (Messages.h): no
  // commanded position, the largest speed, and the default acceleration.
  explicit JointCommands(const RobotConstants* robot);

  // Returns the requests that bring the robot from the values that were sent last to `now`, the
  // values that the controller wants.  From then on, counts the values in these requests as sent.
  // The order is positions, speeds, accelerations (Hohl 2004, 4.2.3); motors are switched with the
  // positions.  Returns no positions while a motion plays (`is_playing`), because the robot would
  // refuse them; a later call returns them.
  std::vector<RobotCommand> Changes(const BatchMoverCommand& now, bool is_playing);

  // Marks the position of a joint as not sent, because the robot has refused it.  So a later call
  // of Changes() returns it again.
  void Forget(int joint) { sent_[static_cast<size_t>(joint)].position.reset(); }

 private:
  struct SentCommand {
    // The commanded position of the joint that was sent last, in 0.01 degree; nullopt: none was
    // sent.
    std::optional<Sint32> position;
    Sint32 speed;
    Sint32 acceleration;
    bool is_off = false;
  };

  void AddPosition(int joint, const BatchJoint& now, bool is_playing,
                   std::vector<RobotCommand>* commands);

  const RobotConstants* const robot_;
  std::vector<SentCommand> sent_;
};

}  // namespace openr_host
