// The robot as rigid bodies in ODE: boxes of uniform density, one hinge per joint, servos
// that drive torques, contacts of paws and boxes with floor and static boxes.
//
// docs/body.md gives the parameters, their sources and what they were measured to do.
// ODE has two things of which a process has only one.  Its random generator is set from the body
// before every step and put back after it; its thread pool is never used.
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "virtualrobot/body.h"
#include "virtualrobot/kinematics.h"
#include "virtualrobot/ode/hinge_measure.h"
#include "virtualrobot/servo.h"

// ODE's world, body and joint.  Declared here because only virtualrobot/ode includes ODE's headers.
struct dxWorld;
struct dxBody;
struct dxJoint;

namespace openr_host {

class ContactFinder;
class ContactSolver;

// Parameters of the simulation.  Every run has the defaults; tests and benchmarks may ask for
// another solver or step.
struct OdeSettings {
  enum class Solver { kExact, kQuick };  // dWorldStep, dWorldQuickStep
  Solver solver = Solver::kExact;
  int steps_per_frame = 1;
  int quick_iterations = 20;      // iterations of a step with kQuick
  double joint_erp = 0.2;         // share of a hinge's error corrected per step
  double joint_cfm = 1e-9;        // softness of hinges, SI
  double contact_erp = 0.2;       // share of the depth pushed out per step
  double contact_cfm = 2e-3;      // softness of contacts, m/s per N, in all directions
  bool hold_contacts = true;      // cheap treatment of contacts that stick (contact_solver.h)
  double depart_speed_m_s = 0.5;  // fastest push out of a contact
  ServoSettings servo;
};

class OdeBody : public Body {
 public:
  // `model` must outlive the body.  Throws std::runtime_error when `model` has a part
  // without box or mass, or a joint without torque.
  OdeBody(const RobotModel& model, const World& world, const OdeSettings& settings = {});
  ~OdeBody() override;

  void Advance(const std::vector<JointCommand>& commands) override;
  const BodyState& state() const override { return state_; }
  double RayDistance(const Eigen::Vector3d& p_W, const Eigen::Vector3d& direction_W,
                     double max_m) const override;
  std::vector<Eigen::Isometry3d> BodyPoses() const override;
  void HashState(Hasher* hasher) const override;

  // Pushes part `body` with `force_W` (N) at `p_W` during the next Advance() only.
  void Push(int body, const Eigen::Vector3d& force_W, const Eigen::Vector3d& p_W);

  // Largest distance in metres between the two ends of a hinge: how well joints hold.
  double HingeError() const;

 private:
  struct PushForce {
    int body;
    Eigen::Vector3d force_W, p_W;
  };

  void MakeBodies(const RestingPose& pose, const std::vector<Eigen::Isometry3d>& X_BL);
  void MakeHinges(const RestingPose& pose, const std::vector<Eigen::Isometry3d>& X_BL);
  void Step(double step_s);
  void SolveStep(double step_s);
  void ReadState();
  Eigen::Isometry3d PoseOf(int body) const;

  const RobotModel& model_;
  const World surroundings_;
  const OdeSettings settings_;
  BodyState state_;
  dxWorld* world_;
  std::vector<dxBody*> bodies_;   // order of RobotModel::bodies
  std::vector<dxJoint*> hinges_;  // order of RobotModel::joints, as are the next two
  std::vector<HingeAxis> axes_;
  std::vector<Servo> servos_;
  std::unique_ptr<ContactFinder> finder_;
  std::unique_ptr<ContactSolver> solver_;
  std::vector<PushForce> pushes_;  // forces of the next Advance()
  uint64_t random_seed_ = 1;       // state of ODE's generator for this world
};

}  // namespace openr_host
