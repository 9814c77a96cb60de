// The robot with physics: parts joined by hinges, servos that turn the hinges, and contacts of paws
// and boxes with the floor and the things of the world.
//
// ODE has the bodies, their masses and their geometry, and finds the contacts with boxes of the
// world. JointTree moves the parts (dynamics/joint_tree.h), with the impulses that ContactForces
// finds (dynamics/contact_forces.h); after each step the bodies of ODE are put in their new places.
// docs/body.md gives the parameters, their sources and their measured effects.
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "virtualrobot/body.h"
#include "virtualrobot/dynamics/contact_forces.h"
#include "virtualrobot/dynamics/joint_tree.h"
#include "virtualrobot/kinematics.h"
#include "virtualrobot/servo.h"

// ODE's world and body.  They are declared here because only virtualrobot/ode includes ODE's
// headers.
struct dxWorld;
struct dxBody;

namespace openr_host {

class ContactFinder;
struct ContactPoint;

// Parameters of the simulation.  Every run of the program has the defaults; tests may use others.
struct OdeSettings {
  int steps_per_frame = 1;
  double contact_erp = 0.2;       // share of a contact's depth that is corrected in one step
  double contact_cfm = 2e-3;      // softness of contacts, in m/s per N, in all directions
  double depart_speed_m_s = 0.5;  // highest speed at which a contact's depth is corrected
  ServoSettings servo;
};

class OdeBody : public Body {
 public:
  // Makes a body in the model's sleeping posture.  `model` must outlive the body.  Throws
  // std::runtime_error when `model` has a part without box or mass, or a joint without torque.
  OdeBody(const RobotModel& model, const World& world, const OdeSettings& settings = {});
  // Makes a body at rest at `pose` with the joint angles `angles_rad`.
  OdeBody(const RobotModel& model, const World& world, const RestingPose& pose,
          const std::vector<double>& angles_rad, const OdeSettings& settings = {});
  ~OdeBody() override;

  void Advance(const std::vector<JointCommand>& commands) override;
  const BodyState& state() const override { return state_; }
  RayHit CastRay(const Eigen::Vector3d& p_W, const Eigen::Vector3d& direction_W,
                 double max_m) const override;
  const World& world() const override { return surroundings_; }
  std::vector<Eigen::Isometry3d> BodyPoses() const override;
  void HashState(Hasher* hasher) const override;

  bool IsPhysical() const override { return true; }
  void Push(int part, const Eigen::Vector3d& force_W, const Eigen::Vector3d& p_W) override;
  void Hold(const std::optional<Eigen::Isometry3d>& X_WB) override;

 private:
  struct PushForce {
    int part;
    Eigen::Vector3d force_W, p_W;
  };

  void MakeTree(const RestingPose& pose, const std::vector<double>& angles_rad);
  void Step(double step_s);
  void SetUpContacts(const std::vector<ContactPoint>& points, double step_s);
  void PullByHand(double step_s);
  void PlaceBodies();
  void ReadState();

  const RobotModel& model_;
  const World surroundings_;
  const OdeSettings settings_;
  BodyState state_;
  dxWorld* world_;
  std::vector<dxBody*> bodies_;  // in the order of RobotModel::bodies
  std::unique_ptr<JointTree> tree_;
  std::vector<Servo> servos_;      // in the order of RobotModel::joints
  std::vector<TorqueLine> lines_;  // of the joint of each part; in the order of RobotModel::bodies
  std::unique_ptr<ContactFinder> finder_;
  ContactEquations equations_;
  ContactForces forces_;
  std::vector<PushForce> pushes_;             // forces that act during the next Advance()
  std::optional<Eigen::Isometry3d> held_at_;  // the pose to which a hand pulls the base
};

}  // namespace openr_host
