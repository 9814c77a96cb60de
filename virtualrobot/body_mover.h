// Moves a body by set points without objects, as a careful program would move the robot: for checks
// of models and for tests.
#pragma once

#include <string>
#include <vector>

#include "virtualrobot/body.h"

namespace openr_host {

class BodyMover {
 public:
  // All joints begin limp, with the vendor's gains.  Both must outlive the mover.
  BodyMover(const RobotModel& model, Body* body);

  // Simulates one frame, or the frames of `seconds`.
  void Frame() { body_.Advance(commands); }
  void Hold(double seconds);

  // Switches all gains on at the present positions.
  void EnableAll();

  // Moves to these angles.  All joints start and arrive together; the slowest moves at 0.9 of its
  // planned speed limit.
  void RampTo(const std::vector<double>& to_rad);

  // Returns a posture of the model, kept to the software limits.  Throws like PostureAngles().
  std::vector<double> Posture(const std::string& name) const;

  // Enables all joints and stands up through the postures broadbase, sleep, crouch and stand.  A
  // posture that the model does not have is left out.
  void StandUp();

  // Returns the largest distance of a joint from its set point, in degrees.
  double JointErrorDegrees() const;

  std::vector<JointCommand> commands;  // in the order of RobotModel::joints

 private:
  const RobotModel& model_;
  Body& body_;
};

// Returns the number of frames that are nearest to `seconds`.
int FramesIn(double seconds);

}  // namespace openr_host
