// Dog: the data of a robot that motions need.  These are two kinds of legs, each in its plane,
// limits, postures, and the pose of the body over paws on a flat floor.
#pragma once

#include <string>
#include <vector>

#include "RobotDescription.h"
#include "leg.h"
#include "openr/motion/mtn_writer.h"

namespace openr_host::motions {

// The pose of the body, and the places of the paws, which are symmetrical left and right.  Places
// are in millimetres, seen from the floor below the middle of the four J1 axes; angles are in
// radians.
struct Stance {
  double height_mm = 0;  // height of the middle of the J1 axes over the floor
  double pitch_rad = 0;  // pitch of the body; positive: nose up
  double fore_mm = 0;    // places of the paws; forward is positive
  double hind_mm = 0;
  double tilt_rad = 0;  // tilt angle of the neck
};

Stance Blend(const Stance& from, const Stance& to, double share);

// The offset of a paw from its place in the stance, forward and up, in millimetres.
struct PawOffset {
  double forward_mm = 0, lift_mm = 0;
};
struct PawOffsets {
  PawOffset lf, lh, rf, rh;
};

class Dog {
 public:
  // Reads the geometry from a robot model (JSON), and takes limits and postures from the objects'
  // constants.  Throws std::runtime_error with file and field.
  explicit Dog(const std::string& model_path);

  const RobotConstants& robot() const { return *robot_; }

  bool is_ers7() const { return neck_tilt_ == "neck_tilt1"; }

  // Returns the design label of the vendor's motion files for this robot.
  const std::string& design_label() const { return design_label_; }

  // Returns the locators of the joints in the vendor's motion files for this robot: neck and legs,
  // and more for the ERS-7.
  std::vector<std::string> Locators() const;

  // Returns the stance of a posture of the model in which all paws touch one plane.
  Stance StanceOf(const std::string& posture) const;

  // Returns the key frame with exactly the angles of a posture of the model.
  KeyFrame FrameOf(const std::string& posture) const;

  // Computes a key frame by inverse kinematics.  Throws std::domain_error, with `what`, if a paw
  // cannot be reached or a joint leaves its software limits.
  KeyFrame FrameOf(const Stance& stance, const PawOffsets& offsets, const std::string& what) const;

  // Returns key frames on the way between two poses, without the first pose; the last key frame is
  // `to.frame`.  Body and paws move from stance to stance, slowly at both ends.  A posture of the
  // model may bend a nearly straight knee the other way than inverse kinematics does; the
  // difference is reduced along the way.
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
  // Returns the place of joint `joint` of the robot in key frames, or -1 when motions leave it
  // alone.
  int PlaceOf(int joint) const { return places_[static_cast<size_t>(joint)]; }
  // Returns the key frame with all joints at 0, but for the upper tilt axis of the ERS-7 and for
  // joints that cannot be at 0: these are as in standing.
  KeyFrame Straight() const;

  const RobotConstants* robot_;
  double axis_mm_ = 0;  // distance of the J1 axes from the middle of the body
  double ball_mm_ = 0;  // radius of the ball of a paw
  Leg fore_{{}, {}}, hind_{{}, {}};
  std::vector<int> places_;  // [joint], see PlaceOf()
  std::string neck_tilt_;    // name of the joint that stances tilt
  std::string design_label_;
};

}  // namespace openr_host::motions
