// The seam to physics: one robot body in its world, advanced frame by frame.
//
// A Body belongs to one virtual robot, is touched from one thread, and is a
// deterministic function of its model, its world, its seed and the commands it
// was given.  Angles are radians, lengths metres, frames 8 ms of virtual time.
// World W and base B are right-handed with x forward, y left, z up; B's origin is
// the midpoint of the four leg J1 axes (docs/body.md).
#pragma once

#include <Eigen/Geometry>
#include <memory>
#include <vector>

#include "virtualrobot/model/robot_model.h"
#include "virtualrobot/world.h"

namespace openr_host {

class Hasher;

inline constexpr double kFrame_s = 0.008;
inline constexpr double kGravity_m_s2 = 9.80665;

// What one joint's servo is told for one frame.
struct JointCommand {
  double target_rad = 0;  // set point in force during the frame
  bool enabled = false;   // gain enabled and motor power on; otherwise the joint is limp
  PidGains gains;
};

// What one joint's sensors report at the end of a frame.
struct JointState {
  double angle_rad = 0;
  double speed_rad_s = 0;
  double drive = 0;  // what the servo asked for, in PWM counts, before the clamp at +-255
};

struct BodyState {
  Eigen::Isometry3d X_WB = Eigen::Isometry3d::Identity();
  Eigen::Vector3d v_WB = Eigen::Vector3d::Zero();  // of B's origin, in W, m/s
  Eigen::Vector3d w_WB = Eigen::Vector3d::Zero();  // in W, rad/s
  // Gravity minus acceleration of B's origin, mean of the frame, in B, m/s^2: what an
  // accelerometer of the robot reads, about (0, 0, -9.8) when it stands still.
  Eigen::Vector3d gravity_B = Eigen::Vector3d::Zero();
  std::vector<JointState> joints;  // order of RobotModel::joints
  std::vector<bool> paws;          // order of RobotModel::paws: touches something
};

class Body {
 public:
  virtual ~Body() = default;

  // Runs one 8 ms frame.  REQUIRES: commands.size() == model.joints.size().
  virtual void Advance(const std::vector<JointCommand>& commands) = 0;

  virtual const BodyState& state() const = 0;

  // Distance in metres from `p_W` along the unit vector `direction_W` to the first
  // thing that is not the robot itself; `max_m` when nothing is nearer.
  virtual double RayDistance(const Eigen::Vector3d& p_W, const Eigen::Vector3d& direction_W,
                             double max_m) const = 0;

  // X_WL of all parts, order of RobotModel::bodies: maps a point as the model file gives it
  // (in B at zero angles: box centres, sensors, camera) to where it is in W now.
  virtual std::vector<Eigen::Isometry3d> BodyPoses() const = 0;

  // Adds everything that decides the future to `hasher`.
  virtual void HashState(Hasher* hasher) const = 0;
};

// Both start in the model's sleeping posture, at rest on the floor, limp.
// `model` must outlive the body.
std::unique_ptr<Body> MakeIdealBody(const RobotModel& model, const World& world);
std::unique_ptr<Body> MakeOdeBody(const RobotModel& model, const World& world);

}  // namespace openr_host
