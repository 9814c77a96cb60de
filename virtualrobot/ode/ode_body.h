// The robot as rigid bodies in the physics engine ODE: boxes of uniform density, one hinge per
// joint, servos that drive the hinges with torques, and contacts of paws and boxes with the floor
// and with static boxes.
//
// docs/body.md gives the parameters, their sources and their measured effects.  ODE has only one
// random generator and one thread pool per process.  Before every step, the generator gets this
// body's seed; after the step, it gets its old state back.  The thread pool is never used.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "virtualrobot/body.h"
#include "virtualrobot/kinematics.h"
#include "virtualrobot/ode/hinge_measure.h"
#include "virtualrobot/servo.h"

// ODE's world, body and joint.  They are declared here because only virtualrobot/ode includes ODE's
// headers.
struct dxWorld;
struct dxBody;
struct dxJoint;

namespace openr_host {

class ContactFinder;
class ContactSolver;

// Parameters of the simulation.  Every run of the program has the defaults; tests and benchmarks
// may use another solver or step.
struct OdeSettings {
  enum class Solver { kExact, kQuick };  // kExact: dWorldStep(); kQuick: dWorldQuickStep()
  Solver solver = Solver::kExact;
  int steps_per_frame = 1;
  int quick_iterations = 20;  // number of iterations of a step with kQuick
  double joint_erp = 0.2;     // share of a hinge's position error that is corrected in one step
  double joint_cfm = 1e-9;    // softness of hinges, in SI units
  double contact_erp = 0.2;   // share of a contact's depth that is corrected in one step
  double contact_cfm = 2e-3;  // softness of contacts, in m/s per N, in all directions
  bool hold_contacts = true;  // whether contacts that stick are treated cheaply (contact_solver.h)
  double depart_speed_m_s = 0.5;  // highest speed at which a contact's depth is corrected
  ServoSettings servo;
};

class OdeBody : public Body {
 public:
  // Makes a body in the model's sleeping posture.  `model` must outlive the body.  Throws
  // std::runtime_error when `model` has a part without box or mass, or a joint without torque.
  OdeBody(const RobotModel& model, const World& world, const OdeSettings& settings = {});
  ~OdeBody() override;

  void Advance(const std::vector<JointCommand>& commands) override;
  const BodyState& state() const override { return state_; }
  double RayDistance(const Eigen::Vector3d& p_W, const Eigen::Vector3d& direction_W,
                     double max_m) const override;
  std::vector<Eigen::Isometry3d> BodyPoses() const override;
  void HashState(Hasher* hasher) const override;

  bool IsPhysical() const override { return true; }
  void Push(int part, const Eigen::Vector3d& force_W, const Eigen::Vector3d& p_W) override;
  void Hold(const std::optional<Eigen::Isometry3d>& X_WB) override;

  // Returns the largest distance, in metres, between the two ends of a hinge.  It tells how well
  // the hinges hold the parts together.
  double HingeError() const;

 private:
  struct PushForce {
    int part;
    Eigen::Vector3d force_W, p_W;
  };

  void MakeBodies(const RestingPose& pose, const std::vector<Eigen::Isometry3d>& X_BL);
  void MakeHinges(const RestingPose& pose, const std::vector<Eigen::Isometry3d>& X_BL);
  void Step(double step_s);
  void SolveStep(double step_s);
  void PullByHand(double step_s);
  void ReadState();
  Eigen::Isometry3d PoseOf(int body) const;

  const RobotModel& model_;
  const World surroundings_;
  const OdeSettings settings_;
  BodyState state_;
  dxWorld* world_;
  std::vector<dxBody*> bodies_;   // in the order of RobotModel::bodies
  std::vector<dxJoint*> hinges_;  // in the order of RobotModel::joints, like axes_ and servos_
  std::vector<HingeAxis> axes_;
  std::vector<Servo> servos_;
  std::unique_ptr<ContactFinder> finder_;
  std::unique_ptr<ContactSolver> solver_;
  std::vector<PushForce> pushes_;             // forces that act during the next Advance()
  std::optional<Eigen::Isometry3d> held_at_;  // the pose to which a hand pulls the base
  uint64_t random_seed_ = 1;                  // state of ODE's random generator for this world
};

}  // namespace openr_host
