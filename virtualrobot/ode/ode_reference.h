// OdeReference: a robot that ODE's own joints and ODE's exact solver move.  A test compares the
// motion of OdeBody with the motion of this robot.  bench/graph_rows.cc compares the times that
// both need to compute a frame.  No run of the program uses OdeReference.
//
// Unlike JointTree, ODE computes 6 velocities for each part and holds the parts together by 5
// equations for each hinge.  A motor at each hinge stands for the servo, whose torque t at the
// speed v is t = t0 - b v.  Such a motor has the parameters vel and cfm and obeys v = vel - cfm *
// t, so vel = t0 / b and cfm = 1 / b.
#pragma once

#include <Eigen/Geometry>
#include <memory>
#include <vector>

#include "virtualrobot/body/body.h"
#include "virtualrobot/dynamics/servo.h"

struct dxWorld;
struct dxBody;
struct dxJoint;
struct dxJointGroup;

namespace openr_host {

class ContactFinder;

class OdeReference {
 public:
  // Makes the robot at rest.  `model` must outlive the robot and have boxes, masses and torques.
  OdeReference(const RobotModel& model, const World& world, const Eigen::Isometry3d& X_WB,
               const std::vector<double>& angles_rad);
  ~OdeReference();
  OdeReference(const OdeReference&) = delete;
  OdeReference& operator=(const OdeReference&) = delete;

  // Moves the robot by one frame of 8 ms.
  void Advance(const std::vector<JointCommand>& commands);

  // Pushes part `part` with `force_W`, in N, at `p_W` during the next frame.
  void Push(int part, const Eigen::Vector3d& force_W, const Eigen::Vector3d& p_W);

  // The next functions return the present angles and speeds of the joints, and the places and
  // velocities of the parts.
  double angle_rad(int joint) const;
  double speed_rad_s(int joint) const;
  Eigen::Vector3d centre_W(int part) const;
  Eigen::Vector3d v_W(int part) const;  // velocity of the part's centre of mass
  Eigen::Vector3d w_W(int part) const;

 private:
  void AddContacts();

  const World surroundings_;
  dxWorld* world_;
  dxJointGroup* contacts_;
  std::vector<dxBody*> bodies_;
  std::vector<dxJoint*> hinges_;
  std::vector<double> start_rad_;  // angles at the start, from which ODE's hinges count
  std::vector<Servo> servos_;
  std::unique_ptr<ContactFinder> finder_;
};

}  // namespace openr_host
