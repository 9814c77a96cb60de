// The robot with physics: parts joined by hinges, and servos that turn the hinges.
//
// ODE has the bodies, their masses and their geometry. JointTree moves the parts
// (dynamics/joint_tree.h); after each step the bodies of ODE are put in their new places. The world
// in which the robot is (ode/physics_world.h) runs the steps and finds the forces of contacts.
// docs/body.md gives the parameters, their sources and their measured effects.
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "virtualrobot/body/body.h"
#include "virtualrobot/body/kinematics.h"
#include "virtualrobot/dynamics/joint_tree.h"
#include "virtualrobot/dynamics/servo.h"
#include "virtualrobot/ode/physics_world.h"

namespace openr_host {

class OdeBody : public Body {
 public:
  // The next two constructors make a body in the model's sleeping posture, alone in a world of its
  // own or in `world`.  `model` must outlive the body.  They throw std::runtime_error when `model`
  // has a part without box or mass, or a joint without torque.
  OdeBody(const RobotModel& model, const World& world, const OdeSettings& settings = {});
  OdeBody(const RobotModel& model, std::shared_ptr<PhysicsWorld> world, const StartPlace& start);
  // Makes a body, alone in its world, at rest at `pose` with the joint angles `angles_rad`.
  OdeBody(const RobotModel& model, const World& world, const RestingPose& pose,
          const std::vector<double>& angles_rad, const OdeSettings& settings = {});

  using Body::Advance;
  void SetCommands(const std::vector<JointCommand>& commands) override;
  void Advance() override { world_->Advance(); }
  const BodyState& state() const override { return state_; }
  RayHit CastRay(const Eigen::Vector3d& p_W, const Eigen::Vector3d& direction_W,
                 double max_m) const override;
  const World& world() const override { return world_->world(); }
  std::vector<WorldThing> Surroundings() const override;
  std::vector<WorldThing> MovableThings() const override;
  bool PutThing(size_t thing, const Eigen::Vector3d& centre_m) override;
  std::vector<Eigen::Isometry3d> BodyPoses() const override;
  void HashState(Hasher* hasher) const override;

  bool IsPhysical() const override { return true; }
  void Push(int part, const Eigen::Vector3d& force_W, const Eigen::Vector3d& p_W) override;
  void Hold(const std::optional<Eigen::Isometry3d>& X_WB) override;

  // ---- Functions for PhysicsWorld
  const RobotModel& model() const { return model_; }
  const std::vector<dxBody*>& ode_bodies() const { return bodies_; }
  JointTree& tree() { return *tree_; }
  void BeginFrame();
  // Begins a step of `step_s` seconds: sets up the tree with the forces of the servos, of pushes
  // and of a person's hand.
  void BeginStep(double step_s);
  void NotePawContact(int paw) { state_.paws[paw] = true; }
  // Adds `force_n` to the average force that presses paw `paw` in this frame.  Called in each step
  // with the impulse of the step, divided by the length of the frame.
  void NotePawForce(int paw, double force_n) {
    state_.paw_forces_n[static_cast<size_t>(paw)] += force_n;
  }
  void EndStep();
  void EndFrame();

 private:
  struct PushForce {
    int part;
    Eigen::Vector3d force_W, p_W;
  };

  OdeBody(const RobotModel& model, std::shared_ptr<PhysicsWorld> world, const RestingPose& pose,
          const std::vector<double>& angles_rad);

  void MakeTree(const RestingPose& pose, const std::vector<double>& angles_rad);
  void PullByHand(double step_s);
  void PlaceBodies();
  void ReadState();

  const RobotModel& model_;
  const std::shared_ptr<PhysicsWorld> world_;
  BodyState state_;
  Eigen::Vector3d v_before_W_{0, 0, 0};  // velocity of B's origin at the beginning of the frame
  std::vector<dxBody*> bodies_;          // bodies of ODE, in the order of RobotModel::bodies
  std::unique_ptr<JointTree> tree_;
  std::vector<Servo> servos_;  // servos of the joints, in the order of RobotModel::joints
  // The torques of the servos, each as a linear function of the speed of its joint.  The element of
  // a part, in the order of RobotModel::bodies, is for the joint that moves the part.
  std::vector<TorqueLine> lines_;
  std::vector<PushForce> pushes_;             // forces that act during the next Advance()
  std::optional<Eigen::Isometry3d> held_at_;  // the pose to which a hand pulls the base
};

}  // namespace openr_host
