// The robot as rigid bodies in ODE: boxes of uniform density, one hinge per joint, servos
// that drive torques, contacts of paws and boxes with floor and static boxes.
//
// docs/body.md gives the parameters, their sources and what they were measured to do.
// ODE is process-wide in two ways, both taken care of: its random generator is set from
// the body before every step and put back after it; its thread pool is never used.
#pragma once

#include <memory>

#include "virtualrobot/body.h"
#include "virtualrobot/servo.h"

namespace openr_host {

// The one parameter set; tests and benchmarks may ask for another solver or step.
struct OdeSettings {
  enum class Solver { kExact, kQuick };  // dWorldStep, dWorldQuickStep
  Solver solver = Solver::kExact;
  int steps_per_frame = 1;
  int quick_iterations = 20;      // of kQuick
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
  const BodyState& state() const override;
  double RayDistance(const Eigen::Vector3d& p_W, const Eigen::Vector3d& direction_W,
                     double max_m) const override;
  std::vector<Eigen::Isometry3d> BodyPoses() const override;
  void HashState(Hasher* hasher) const override;

  // Pushes part `body` with `force_W` (N) at `p_W` during the next Advance() only.
  void Push(int body, const Eigen::Vector3d& force_W, const Eigen::Vector3d& p_W);

  // Largest distance in metres between the two ends of a hinge: how well joints hold.
  double HingeError() const;

 private:
  class Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace openr_host
