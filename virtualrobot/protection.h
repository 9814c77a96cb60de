// The protective shutdowns of a robot, beside the overload that JointWatch finds: a battery that
// gives too much current or gets too hot, and on the ERS-7 a jammed joint.  The model files have
// the limits; field-notes.md, 7.20 to 7.22, has what is known of them.
#pragma once

#include <string>
#include <vector>

#include "virtualrobot/body.h"
#include "virtualrobot/energy.h"
#include "virtualrobot/model/robot_model.h"

namespace openr_host {

class Hasher;

class Protection {
 public:
  // `model` must outlive this object.
  explicit Protection(const RobotModel& model);

  // A reason why the robot shuts down.
  struct Reason {
    std::string finding;  // what the robot says, and why
    std::string end;      // reason for the end of the run
  };

  // Notes a frame of 8 ms, after the body has moved.  Returns the reasons for a shutdown that begin
  // with this frame.
  std::vector<Reason> NoteFrame(const BodyState& body, const Energy& energy, bool charging);

  // Returns whether the battery now gives more current than its limit.
  bool over_current() const { return over_current_; }
  // Returns whether the battery is now hotter than its limit.
  bool over_temperature() const { return heat_ != Heat::kNone; }

  // Forgets all observations, because the robot is switched off.
  void SwitchOff();

  void HashState(Hasher* hasher) const;

 private:
  void FindJam(const BodyState& body, std::vector<Reason>* reasons);

  const RobotModel& model_;
  // The temperature limit that the battery exceeds now: one holds while it charges, one otherwise.
  enum class Heat { kNone, kDischarging, kCharging };

  bool over_current_ = false;
  Heat heat_ = Heat::kNone;
  std::vector<int> jammed_frames_;  // [joint]; empty for a model without detection of jams
};

}  // namespace openr_host
