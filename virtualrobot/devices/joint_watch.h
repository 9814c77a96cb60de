// Finds common mistakes of programs that move joints, and reports each mistake once per joint
// (field-notes.md, 7):
//   - a servo begins to act while its set point is far from the joint's position,
//   - set points jump,
//   - set points have no effect, because power or gain is off,
//   - set points are in radians instead of microradians,
//   - joints of an ERS-7 are given different shifts of their gains, although the joints share one
//     register for the shifts,
//   - a motor pushes with at least 78 % of its largest drive for 30 s.
//
// A servo acts when it has motor power and a P gain; otherwise its joint is limp.  A frame is 8 ms.
#pragma once

#include <cstdint>
#include <limits>
#include <string>
#include <vector>

#include "virtualrobot/body/body.h"
#include "virtualrobot/devices/command_vector.h"
#include "virtualrobot/devices/devices.h"

namespace openr_host {

class Hasher;

class JointWatch {
 public:
  // `model` and `devices` must outlive the watch.
  JointWatch(const RobotModel& model, const Devices& devices);

  // Checks the servos that begin to act (have motor power and a P gain now), and adds a text for
  // each mistake to `problems`.  Called after each change of gains or motor power.
  void ServosChanged(const BodyState& body, bool motor_power, std::vector<std::string>* problems);

  // Checks a command vector, before its first frame is played, and adds a text for each mistake to
  // `problems`.  Set points without effect are normally a mistake.  They are not reported when the
  // pause button has cut motor power (`motor_power_cut`), because the program may have been in the
  // middle of a movement.
  void VectorStarts(const std::vector<CommandElement>& elements, const BodyState& body,
                    bool motor_power, bool motor_power_cut, std::vector<std::string>* problems);

  // Records the drives and angles of the joints.  Called after every frame.  Returns the indices of
  // the motors whose drive has been 78 % of its limit or more in all frames of the last 30 s; a
  // longer overload is returned only once.  The limits are from Sony's support (BBS 1735); how the
  // robot averages the drive is not known.
  std::vector<int> NoteFrame(const BodyState& body);

  // Forgets all that was recorded about the joints and which mistakes were reported, because the
  // robot is switched off.
  void SwitchOff();

  void HashState(Hasher* hasher) const;

 private:
  struct Range_rad {
    double low = std::numeric_limits<double>::infinity();
    double high = -std::numeric_limits<double>::infinity();
  };
  struct Joint {
    bool acted = false;  // whether the servo had power and a P gain at the last ServosChanged()
    // Each of the next four members says whether a mistake of the program has been reported for
    // this joint already, because each mistake is reported only once.
    bool reported_start = false;      // a servo begins to act far from its set point
    bool reported_jump = false;       // set points jump
    bool reported_no_effect = false;  // set points have no effect
    bool reported_radians = false;    // set points are in radians instead of microradians
    bool was_in_urad = false;         // whether a set point was too large to be an angle in radians
    int radian_like_frames = 0;       // number of successive set points that look like radians
    int loaded_frames = 0;
    // Whether the servo has acted since boot, that is, has had motor power and a P gain.  Until
    // then, NoteLimpJoints() records the range of the joint's positions for HasSunk(): half a
    // second is recorded in `now`, then this range becomes `before`, and `now` begins anew.
    bool has_acted = false;
    Range_rad now, before;
  };

  // Returns whether `joint`, while limp, was near `goal_rad` in the last second.  Such a joint has
  // only sunk away from its goal, so it is no mistake of the program if the joint is far from the
  // goal now.  Returns false if the servo has acted since boot (has had motor power and a P gain).
  static bool HasSunk(const Joint& joint, double goal_rad);
  // Records the positions of the joints whose servos have not acted since boot (had no motor power
  // or no P gain).
  void NoteLimpJoints(const BodyState& body);

  void CheckForJump(size_t joint, const CommandElement& element, double measured_rad,
                    std::vector<std::string>* problems);
  void CheckForRadians(size_t joint, const CommandElement& element,
                       std::vector<std::string>* problems);

  // Checks whether the last calls of SetJointGain() for two joints ask for different shifts (powers
  // of 2 that scale the gains), on a robot whose joints share one register for the shifts.  A
  // program that changes the shifts of all joints, one after the other, makes no mistake; so this
  // is checked when a command vector starts and not at each change.
  void CheckShifts(std::vector<std::string>* problems);

  const RobotModel& model_;
  const Devices& devices_;
  std::vector<Joint> joints_;
  bool has_reported_shifts_ = false;  // whether CheckShifts() has reported shifts that differ
  int limp_frames_ = 0;               // number of frames since NoteLimpJoints() began Joint::now
};

}  // namespace openr_host
