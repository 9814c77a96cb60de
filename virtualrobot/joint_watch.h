// What developers did to joints without meaning it, noticed and said once per joint: servos
// that begin to act far from where the joint is, set points that jump, commands that cannot
// have an effect, radians for micro-radians, a motor that pushes for half a minute
// (field-notes.md, 7).
#pragma once

#include <cstdint>
#include <limits>
#include <string>
#include <vector>

#include "virtualrobot/body.h"
#include "virtualrobot/command_vector.h"
#include "virtualrobot/devices.h"

namespace openr_host {

class Hasher;

class JointWatch {
 public:
  // `model` and `devices` must outlive the watch.
  JointWatch(const RobotModel& model, const Devices& devices);

  // After a change of gains or motor power: servos that act from now on.
  void ServosChanged(const BodyState& body, bool motor_power, std::vector<std::string>* problems);

  // Before the first frame of a vector with these elements.  `motor_power_cut`: by the
  // pause button, so that programs in the middle of a movement are not to blame.
  void VectorStarts(const std::vector<CommandElement>& elements, const BodyState& body,
                    bool motor_power, bool motor_power_cut, std::vector<std::string>* problems);

  // After every frame.  Index of a motor that has been asked for 78 % of its drive or more
  // for 30 s without a break (BBS 1735, support; how the robot averages is not known);
  // -1: none.
  int OverloadedJoint(const BodyState& body);

  void HashState(Hasher* hasher) const;

 private:
  struct Range_rad {
    double low = std::numeric_limits<double>::infinity();
    double high = -std::numeric_limits<double>::infinity();
  };
  struct Joint {
    bool acted = false;       // when it was last looked at
    bool told_start = false;  // what has been said
    bool told_jump = false;
    bool told_effect = false;
    bool told_radians = false;
    bool was_in_urad = false;  // a set point that no radian reaches
    int tiny_frames = 0;       // successive set points that look like radians
    int loaded_frames = 0;
    // Until its servo acts for the first time: where it was in this half second and the one before.
    bool has_acted = false;
    Range_rad now, before;
  };

  // Whether the joint was at `goal_rad` a moment ago and only sank since then.
  static bool Sank(const Joint& joint, double goal_rad);
  void FollowLimpJoints(const BodyState& body);

  void LookForJump(size_t joint, const CommandElement& element, double measured_rad,
                   std::vector<std::string>* problems);
  void LookForRadians(size_t joint, const CommandElement& element,
                      std::vector<std::string>* problems);

  const RobotModel& model_;
  const Devices& devices_;
  std::vector<Joint> joints_;
  int limp_frames_ = 0;  // of this half second
};

}  // namespace openr_host
