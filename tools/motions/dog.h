// The ERS-210 as its motions need it: two kinds of legs in the plane, limits, postures, and the
// pose of the body over paws on a flat floor.
#pragma once

#include <string>
#include <vector>

#include "RobotDescription.h"
#include "leg.h"
#include "openr/motion/mtn_writer.h"

namespace openr_host::motions {

// Body and paws, symmetrical left and right.  Millimetres and radians; seen from the floor
// under the middle of the four J1 axes.
struct Stance {
  double height_mm = 0;  // of that middle over the floor
  double pitch_rad = 0;  // nose up positive
  double fore_mm = 0;    // where the paws stand, forward positive
  double hind_mm = 0;
  double tilt_rad = 0;  // of the neck
};

Stance Blend(const Stance& from, const Stance& to, double share);

// What a paw does beyond standing at its place: forward and lifted, millimetres.
struct PawOffset {
  double forward_mm = 0, lift_mm = 0;
};
struct PawOffsets {
  PawOffset lf, lh, rf, rh;
};

class Dog {
 public:
  // Reads the geometry from a robot model (JSON); limits and postures are those of the objects.
  // Throws std::runtime_error naming file and field.
  explicit Dog(const std::string& model_path);

  const RobotConstants& robot() const { return *robot_; }

  // The joints of the vendor's motion files: neck and legs.
  std::vector<std::string> Locators() const;

  // The stance of a posture of the model, whose paws touch one plane.
  Stance StanceOf(const std::string& posture) const;

  // The key frame of a posture of the model, exactly as the model has it.
  KeyFrame FrameOf(const std::string& posture) const;

  // A key frame by inverse kinematics.  Throws std::domain_error naming `what` when a paw
  // is out of reach or a joint leaves its software limits.
  KeyFrame FrameOf(const Stance& stance, const PawOffsets& offsets, const std::string& what) const;

  // Key frames on the way between two postures, which may be of the model or of inverse
  // kinematics; the first is left out, the last is `to.frame`.  Body and paws go from stance to
  // stance, slowly at both ends.  A posture may bend a nearly straight knee the other way than
  // inverse kinematics would; the difference fades along the way.
  struct Pose {
    Stance stance;
    KeyFrame frame;
  };
  std::vector<KeyFrame> Way(const Pose& from, const Pose& to, int count,
                            const std::string& what) const;

  Pose PoseOf(const std::string& posture) const { return {StanceOf(posture), FrameOf(posture)}; }
  Pose PoseOf(const Stance& stance, const std::string& what) const {
    return {stance, FrameOf(stance, {}, what)};
  }

 private:
  LegAngles LegOf(const Leg& leg, double side, const Stance& stance, double place_mm,
                  const PawOffset& offset, const std::string& what) const;
  void Set(KeyFrame* frame, const std::string& joint, double rad, const std::string& what) const;
  int IndexOf(const std::string& joint) const;

  const RobotConstants* robot_;
  double axis_mm_ = 0;  // J1 axes ahead of and behind the middle
  double ball_mm_ = 0;  // radius of a paw
  Leg fore_{{}, {}}, hind_{{}, {}};
};

}  // namespace openr_host::motions
