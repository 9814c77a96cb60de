// Finds reasons for which a robot shuts down to protect itself: the battery gives too much current
// or gets too hot, or a joint of an ERS-7 is jammed.  JointWatch finds another such reason, an
// overloaded motor.  The model files have the limits; field-notes.md, 7.20 to 7.22, has what is
// known of these limits.
#pragma once

#include <string>
#include <vector>

#include "virtualrobot/body/body.h"
#include "virtualrobot/model/robot_model.h"
#include "virtualrobot/power/energy.h"

namespace openr_host {

class Hasher;

class Protection {
 public:
  // `model` must outlive the Protection.
  explicit Protection(const RobotModel& model);

  // A reason why the robot shuts down.
  struct Reason {
    std::string finding;  // text of the finding: what the robot has noticed, and why it shuts down
    std::string end;      // reason for the end of the run
  };

  // Checks the limits at the end of a frame of 8 ms, after the body has moved.  Returns the reasons
  // for a shutdown that are new in this frame.
  std::vector<Reason> NoteFrame(const BodyState& body, const Energy& energy, bool charging);

  // If `is_patient` is true, a joint may be jammed for longer before the robot shuts down.
  void set_patient(bool is_patient) { is_patient_ = is_patient; }
  // Returns the number of frames of 8 ms for which a joint may be jammed; 0: the robot does not
  // look for jams.
  int jam_frames() const;

  // Returns whether the battery now gives more current than its limit.
  bool over_current() const { return over_current_; }
  // Returns whether the battery is now hotter than its limit.
  bool over_temperature() const { return exceeded_limit_ != ExceededLimit::kNone; }

  // Forgets what earlier frames have shown (limits exceeded, joints jammed), because the robot is
  // switched off.
  void SwitchOff();

  void HashState(Hasher* hasher) const;

 private:
  void FindJam(const BodyState& body, std::vector<Reason>* reasons);

  const RobotModel& model_;
  // The temperature limit that the battery exceeds now.  The battery has two limits: one applies
  // while the battery charges (kCharging), the other at all other times (kDischarging).
  enum class ExceededLimit { kNone, kDischarging, kCharging };

  bool is_patient_ = false;
  bool over_current_ = false;
  ExceededLimit exceeded_limit_ = ExceededLimit::kNone;
  // For each joint, the number of successive frames in which the joint was jammed.  Empty for a
  // model without detection of jams.
  std::vector<int> jammed_frames_;
};

}  // namespace openr_host
