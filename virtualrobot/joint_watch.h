// Finds common mistakes of programs that move joints, and reports each mistake once per joint
// (field-notes.md, 7):
//   - a servo begins to act while its set point is far from the joint's position,
//   - set points jump,
//   - set points have no effect, because power or gain is off,
//   - set points are in radians instead of micro-radians,
//   - a motor pushes at its limit for 30 s.
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

  // Checks the servos that begin to act.  Called after each change of gains or motor power.
  void ServosChanged(const BodyState& body, bool motor_power, std::vector<std::string>* problems);

  // Checks a command vector with these elements.  Called before its first frame.  `motor_power_cut`
  // says that the pause button has cut motor power; then set points without effect are no mistake
  // of a program in the middle of a movement.
  void VectorStarts(const std::vector<CommandElement>& elements, const BodyState& body,
                    bool motor_power, bool motor_power_cut, std::vector<std::string>* problems);

  // Notes the state of the joints after a frame, and returns the index of a motor that has just
  // been asked for 78 % of its drive or more for 30 s without a break (BBS 1735, support; how the
  // robot averages is not known); -1 when there is none.  Called after every frame.
  int NoteFrame(const BodyState& body);

  void HashState(Hasher* hasher) const;

 private:
  struct Range_rad {
    double low = std::numeric_limits<double>::infinity();
    double high = -std::numeric_limits<double>::infinity();
  };
  struct Joint {
    bool acted = false;       // whether the servo acted at the last change of gains or power
    bool told_start = false;  // the mistakes that were reported already
    bool told_jump = false;
    bool told_effect = false;
    bool told_radians = false;
    bool was_in_urad = false;  // whether a set point was too large for an angle in radians
    int tiny_frames = 0;       // successive set points that look like radians
    int loaded_frames = 0;
    // Until the servo acts for the first time: range of the joint's positions in this half second
    // and in the one before.
    bool has_acted = false;
    Range_rad now, before;
  };

  // Whether the joint was near `goal_rad` in the last second and, still limp, has only sunk since.
  static bool HasSunk(const Joint& joint, double goal_rad);
  // Notes the positions of joints whose servos have not acted yet.
  void NoteLimpJoints(const BodyState& body);

  void CheckForJump(size_t joint, const CommandElement& element, double measured_rad,
                    std::vector<std::string>* problems);
  void CheckForRadians(size_t joint, const CommandElement& element,
                       std::vector<std::string>* problems);

  const RobotModel& model_;
  const Devices& devices_;
  std::vector<Joint> joints_;
  int limp_frames_ = 0;  // frames of this half second
};

}  // namespace openr_host
