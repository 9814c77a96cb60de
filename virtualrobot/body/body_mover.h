// Moves the joints of a body without jumps, as a careful program would, but without OPEN-R objects.
// Tests and checks of models use this class.
#pragma once

#include <string>
#include <vector>

#include "virtualrobot/body/body.h"

namespace openr_host {

class BodyMover {
 public:
  // Makes a mover of the joints of `body`.  At first the joints are limp, and their servos have the
  // gains of the model file.  `model` and `body` must outlive the mover.
  BodyMover(const RobotModel& model, Body* body);

  // Simulates one frame of the body, with the member `commands` as the commands to its joints.
  void Frame() { body_.Advance(commands); }
  // Simulates frames for `seconds` seconds, with the member `commands` as the commands to the
  // joints.
  void Hold(double seconds);

  // Switches the servos of all joints on, with their present angles as set points, so that no joint
  // jumps.
  void EnableAll();

  // Moves the joints to the angles `to_rad`.  All joints start and arrive together.  The joint that
  // needs the most time moves at 0.9 of the highest speed that the model has for planned movements.
  void RampTo(const std::vector<double>& to_rad);

  // Returns the angles of a posture of the model, limited to the software limits of the joints.
  // Throws std::runtime_error when the model has no such posture.
  std::vector<double> Posture(const std::string& name) const;

  // Switches the servos of all joints on and stands up through the postures broadbase, sleep,
  // crouch and stand.  A posture that the model does not have is left out.
  void StandUp();

  // Returns the largest distance of a joint from its set point, in degrees.
  double JointErrorDegrees() const;

  std::vector<JointCommand> commands;  // commands to the joints, in the order of RobotModel::joints

 private:
  const RobotModel& model_;
  Body& body_;
};

// Returns the number of frames whose duration is nearest to `seconds`.
int FramesIn(double seconds);

}  // namespace openr_host
