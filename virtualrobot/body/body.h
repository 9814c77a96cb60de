// The interface to physics: one robot body in its world, advanced frame by frame.
//
// A Body belongs to one virtual robot and is used by one thread only.  Its behaviour depends only
// on its model, its world and the commands that it was given.  Angles are in radians and
// lengths in metres.  A frame is 8 ms of virtual time.  A joint is limp when its servo is off.
// World W and base B are right-handed, with x forward, y left and z up.  B's origin is the midpoint
// of the axes of the four joints J1, one per leg (docs/body.md).
#pragma once

#include <Eigen/Geometry>
#include <memory>
#include <optional>
#include <vector>

#include "virtualrobot/model/robot_model.h"
#include "virtualrobot/worlds/world.h"

namespace openr_host {

class Hasher;
class PhysicsWorld;

inline constexpr double kFrame_s = 0.008;
inline constexpr double kGravity_m_s2 = 9.80665;

// Disturbance of one joint and its servo by people's hands and by faults.
struct JointDisturbance {
  std::optional<double> hand_rad;    // a hand turns the joint towards this angle
  std::optional<double> jammed_rad;  // the joint is stuck at this angle
  double strength = 1;               // share of the motor's torque that is left, 0 to 1
  std::optional<double> sensed_rad;  // the joint's sensor reports this angle, wherever the joint is
  double sensor_error_rad = 0;       // error of the joint's sensor, added to the angle
  bool is_sensor_dead = false;  // whether the joint's sensor is dead, so its signal means nothing

  bool Exists() const {
    return hand_rad || jammed_rad || strength != 1 || sensed_rad || sensor_error_rad != 0;
  }
  // Returns what the sensor of the joint measures when the joint is at `angle_rad`.
  double Measured(double angle_rad) const {
    return sensed_rad.value_or(angle_rad) + sensor_error_rad;
  }
};

// The command to the servo of one joint for one frame.
struct JointCommand {
  double target_rad = 0;  // set point of the joint during the frame
  bool enabled = false;  // whether the servo has gains and motor power; otherwise the joint is limp
  PidGains gains;
  const JointDisturbance* disturbance = nullptr;  // null: no hand and no fault acts on the joint
};

// The state of one joint at the end of a frame.
struct JointState {
  double angle_rad = 0;
  double speed_rad_s = 0;
  double drive = 0;  // PWM counts that the servo demands, before they are limited to +-255
};

struct BodyState {
  Eigen::Isometry3d X_WB = Eigen::Isometry3d::Identity();
  Eigen::Vector3d v_WB = Eigen::Vector3d::Zero();  // velocity of B's origin, in W, m/s
  Eigen::Vector3d w_WB = Eigen::Vector3d::Zero();  // angular velocity of B, in W, rad/s
  // Gravity minus the acceleration of the origin of the base frame B, averaged over the frame, in
  // the axes of B, in m/s^2.  The accelerometer of the robot reads this vector: about (0, 0, -9.8)
  // when the robot stands still.
  Eigen::Vector3d gravity_B = Eigen::Vector3d::Zero();
  std::vector<JointState> joints;  // states of the joints, in the order of RobotModel::joints
  std::vector<bool> paws;  // for each paw, whether it touches something; order of RobotModel::paws
  // Force that presses each paw, averaged over the frame, in N; in the order of RobotModel::paws.
  // Empty for a body that is not moved by forces (Body::IsPhysical() is false).
  std::vector<double> paw_forces_n;
};

class Body {
 public:
  virtual ~Body() = default;

  // SetCommands() and Advance() simulate a frame of 8 ms in two steps, because several robots can
  // be in one world.  First SetCommands() is called for each robot, then Advance() for each robot.
  // The first call of Advance() simulates the frame for all robots of the world.  REQUIRES:
  // commands.size() == model.joints.size().
  virtual void SetCommands(const std::vector<JointCommand>& commands) = 0;
  virtual void Advance() = 0;

  // Simulates one frame of a robot that is alone in its world.
  void Advance(const std::vector<JointCommand>& commands) {
    SetCommands(commands);
    Advance();
  }

  virtual const BodyState& state() const = 0;

  // Returns whether simulated forces move this body, so that Push() has an effect.  For the body of
  // MakeIdealBody(), the result is false.
  virtual bool IsPhysical() const { return false; }

  // Pushes part `part` (an index of RobotModel::bodies) with `force_W`, in N, at the point `p_W`
  // during the next Advance() only.  Has no effect if IsPhysical() is false.
  virtual void Push(int /*part*/, const Eigen::Vector3d& /*force_W*/,
                    const Eigen::Vector3d& /*p_W*/) {}

  // Lets a person's hand hold the robot from the next frame on: the hand moves the robot's base
  // frame B towards the pose `X_WB` in the world W with a limited force.  nullopt: the hand lets
  // go.
  virtual void Hold(const std::optional<Eigen::Isometry3d>& /*X_WB*/) {}

  // Follows a ray from `p_W` along the unit vector `direction_W`.  Returns the distance and the
  // reflectance of what the ray meets first: the floor or a thing of Surroundings().  If the ray
  // meets nothing within `max_m`, the distance is `max_m`.
  virtual RayHit CastRay(const Eigen::Vector3d& p_W, const Eigen::Vector3d& direction_W,
                         double max_m) const = 0;

  // Returns the world of the robot, with its things in the places where they were at the beginning
  // of the run.
  virtual const World& world() const = 0;

  // Returns what surrounds the robot now: the things of its world in their present places and in
  // the order of World::things, then the parts of other robots in the same world.  Rays hit these
  // things, and cameras see them.
  virtual std::vector<WorldThing> Surroundings() const { return world().things; }

  // Returns the things of the world that can move, in their present places.
  virtual std::vector<WorldThing> MovableThings() const;

  // Puts the movable thing `thing`, an index of World::things, at rest at `centre_m`.  Returns
  // false when this body cannot move things, or when the thing is not movable.
  virtual bool PutThing(size_t /*thing*/, const Eigen::Vector3d& /*centre_m*/) { return false; }

  // Returns the present pose X_WL of each part, in the order of RobotModel::bodies.  The frame L of
  // a part moves with the part, and coincides with the base frame B when all joint angles are 0.
  // The model file gives the points of the part in L.
  virtual std::vector<Eigen::Isometry3d> BodyPoses() const = 0;

  // Returns the present pose of part `part`: element `part` of the result of BodyPoses().
  virtual Eigen::Isometry3d PoseOf(size_t part) const { return BodyPoses()[part]; }

  // Adds the complete state of the body, all that its future depends on, to `hasher`.
  virtual void HashState(Hasher* hasher) const = 0;
};

// MakeIdealBody() and MakeOdeBody() make a body that lies limp and at rest on the floor, in the
// sleeping posture of the model, at the place `start`.  `model` must outlive the body.  With a
// PhysicsWorld, MakeOdeBody() puts the body into this world, together with other robots.
std::unique_ptr<Body> MakeIdealBody(const RobotModel& model, const World& world,
                                    const StartPlace& start = {});
std::unique_ptr<Body> MakeOdeBody(const RobotModel& model, const World& world,
                                  const StartPlace& start = {});
std::unique_ptr<Body> MakeOdeBody(const RobotModel& model, std::shared_ptr<PhysicsWorld> world,
                                  const StartPlace& start);

// Makes a world with physics for several robots.
std::shared_ptr<PhysicsWorld> MakePhysicsWorld(const World& world);

}  // namespace openr_host
