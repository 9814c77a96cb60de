// The motion of a robot as a tree of rigid parts that hinges join.
//
// The unknowns are the velocities that the robot itself can have: six numbers for the motion of the
// trunk and one number for each hinge.  Because a hinge has only one number, nothing can pull the
// parts of a hinge apart, and no equation is needed that holds them together.  Let u be these
// velocities at the beginning of a step of h seconds, and u' at its end.  The step solves
//
//   (M + h B) (u' - u) = h (t0 - B u - c + f) + J^T p
//
// M is the inertia matrix of the tree, t0 - B u' the torque lines of the servos, c the forces that
// the present motion and gravity demand, f pushes, J the Jacobian of the contacts and p their
// impulses.  The element of the matrix for two hinges is zero if neither of them is on the path
// from the other to the trunk.  The factors of the matrix keep these zeros when the leaves of the
// tree are eliminated first (Featherstone, "Rigid Body Dynamics Algorithms", 2008, chapters 6 and
// 8), so that the work grows with the number of hinges and not with its third power.
//
// Vectors are in the axes of the world W.  Moments and lines of force refer to the point O, the
// place of the trunk's centre of mass at the beginning of the step.  All results have the same bits
// in every build, because the code uses only +, -, *, /, sqrt and det_math.h.
#pragma once

#include <Eigen/Geometry>
#include <vector>

#include "virtualrobot/dynamics/servo.h"

namespace openr_host {

class Hasher;

// A rigid part and the hinge that joins it to its parent.  Places and axes are given in the part's
// own frame L, which coincides with the base frame B when all angles are 0.
struct TreePart {
  double mass_kg = 0;                                       // mass of the part, > 0
  Eigen::Matrix3d inertia_kg_m2 = Eigen::Matrix3d::Zero();  // inertia about the centre of mass
  Eigen::Vector3d centre_m{0, 0, 0};                        // place of the centre of mass
  int parent = -1;  // index of the parent, lower than the part's own index; -1 for the trunk
  Eigen::Vector3d axis{0, 0, 0};      // axis of the hinge, a unit vector
  Eigen::Vector3d anchor_m{0, 0, 0};  // a point on the axis of the hinge
};

class JointTree {
 public:
  // A pair of vectors: a force and its moment about the point O (see the top of this file), or a
  // momentum and its moment about O, or an angular velocity and the velocity at O.
  struct Spatial {
    Eigen::Vector3d angular{0, 0, 0};
    Eigen::Vector3d linear{0, 0, 0};
  };

  // Limits of the speeds of trunk and hinges.  At the end of a step, higher speeds are reduced to
  // these limits.  A step computes the forces of turning parts from the speeds at its beginning, so
  // a robot that turns by half a turn in a step would be torn apart.  In normal motion no robot
  // comes near the limits.
  static constexpr double kTurnMax_rad_s = 100;
  static constexpr double kSpeedMax_m_s = 50;

  // Makes a tree at rest whose base frame B coincides with the world W and whose angles are 0.
  // REQUIRES: part 0 is the trunk, and a parent comes before its children.
  explicit JointTree(const std::vector<TreePart>& parts);

  int parts() const { return static_cast<int>(parts_.size()); }

  // Puts the trunk and the hinges in their places, at rest.  `angles_rad` has an angle for each
  // part; the angle of the trunk is not used.
  void Place(const Eigen::Isometry3d& X_WB, const std::vector<double>& angles_rad);

  // The next functions return the present place and motion of the parts.  X_WL maps a point of the
  // part's frame to its place in W.
  const Eigen::Matrix3d& R_WL(int part) const { return part_states_[part].R_WL; }
  const Eigen::Vector3d& centre_W(int part) const { return part_states_[part].centre_W; }
  Eigen::Isometry3d X_WL(int part) const;
  const Eigen::Quaterniond& q_WB() const { return q_WB_; }
  const Eigen::Vector3d& v_W() const { return v_W_; }  // velocity of the trunk's centre of mass
  const Eigen::Vector3d& w_W() const { return w_W_; }  // angular velocity of the trunk
  double angle_rad(int part) const { return angle_rad_[part]; }
  double speed_rad_s(int part) const { return speed_rad_s_[part]; }

  // Begins a step of `step_s` seconds: sets up the equation of motion without pushes and contacts,
  // and factors its matrix.  `lines` has one element for each part: the torque of the servo at the
  // part's hinge, as a linear function of the hinge's speed.  The element of the trunk is not used.
  void BeginStep(const std::vector<TorqueLine>& lines, double gravity_m_s2, double step_s);

  // Pushes `part` with `force_W`, in N, at the point `p_W` during the step that has begun.
  void AddForce(int part, const Eigen::Vector3d& force_W, const Eigen::Vector3d& p_W);
  // Turns `part` with `torque_W`, in N m, during the step that has begun.
  void AddTorque(int part, const Eigen::Vector3d& torque_W);

  // Adds a row to the Jacobian J of the contacts: the velocity of the point `p_W` of `part` along
  // `direction_W`.  Called after all calls of AddForce() and AddTorque() of the step.  Rows are
  // numbered from 0 in each step.
  void AddRow(int part, const Eigen::Vector3d& p_W, const Eigen::Vector3d& direction_W);
  int rows() const { return static_cast<int>(row_speed_.size()); }

  // Returns the velocity along row `row` (a point and a direction that AddRow() has added) that the
  // step would end with if no contact acted, in m/s.
  double FreeSpeed(int row) const { return row_speed_[row]; }

  // Returns by how much an impulse of 1 N s changes a velocity, in m/s.  The impulse acts along row
  // `b` (a point and a direction that AddRow() has added); the velocity is that along row `a`.
  double Mobility(int a, int b) const;

  // Ends the step: applies an impulse along each row that AddRow() has added, in N s, and moves all
  // parts.
  void EndStep(const std::vector<double>& impulses);

  void HashState(Hasher* hasher) const;

 private:
  // Place and motion of a part, which follow from the state of the tree.
  struct PartState {
    Eigen::Matrix3d R_WL = Eigen::Matrix3d::Identity();
    Eigen::Vector3d centre_W{0, 0, 0};
    Spatial axis;  // velocity of the part when its hinge turns with 1 rad/s
    Eigen::Vector3d anchor_W{0, 0, 0};
    Eigen::Vector3d w_W{0, 0, 0};
  };

  // Sum of parts that move as one body: mass, first moment and inertia about the point O (see the
  // top of this file).
  struct Inertia {
    double mass_kg = 0;
    Eigen::Vector3d moment{0, 0, 0};
    Eigen::Matrix3d about_o = Eigen::Matrix3d::Zero();

    // Returns the momentum of the parts that this Inertia sums up, when they move as one body with
    // `velocity`.
    Spatial MomentumAt(const Spatial& velocity) const;
  };

  int Unknowns() const { return 5 + parts(); }
  static int UnknownOf(int part) { return 5 + part; }
  double* RowOf(int unknown) { return &matrix_[static_cast<size_t>(unknown) * Unknowns()]; }
  const double* RowOf(int unknown) const {
    return &matrix_[static_cast<size_t>(unknown) * Unknowns()];
  }

  void PlaceParts();
  void FindMotion();
  void FillMatrix(const std::vector<TorqueLine>& lines, double step_s);
  void FindForces(const std::vector<TorqueLine>& lines, double gravity_m_s2);
  void Factor();
  void AddAlong(int part, const Spatial& force, double* along) const;
  void Eliminate();
  void EliminateFrom(int unknown, double* x) const;
  void Move();

  const std::vector<TreePart> parts_;
  // For each unknown (a velocity of the trunk or of a hinge): the index of the next unknown on the
  // path to unknown 0, which belongs to the trunk; -1 for unknown 0 itself.
  std::vector<int> parent_;

  // The state of the tree: orientation, place and velocities of the trunk, and the angles and
  // speeds of the hinges.  All other members are computed from this state in each step.
  Eigen::Quaterniond q_WB_ = Eigen::Quaterniond::Identity();
  Eigen::Vector3d centre_W_{0, 0, 0};  // the trunk's centre of mass
  Eigen::Vector3d v_W_{0, 0, 0}, w_W_{0, 0, 0};
  std::vector<double> angle_rad_, speed_rad_s_;  // an element for each part

  std::vector<PartState> part_states_;  // an element for each part

  // The members below belong to the step that BeginStep() has begun.
  double step_s_ = 0;
  std::vector<Inertia> inertia_;  // for each part: inertia of the part and all parts it carries
  // For each part: force that the present motion and gravity demand for the part and all parts that
  // it carries.
  std::vector<Spatial> force_;
  // Lower triangle of the matrix M + h B, row by row; after Factor() the factors L and D of this
  // matrix.  M is the inertia of the tree, h the length of a step, and B says by how much the
  // torque of each servo falls when its hinge turns faster.
  std::vector<double> matrix_;
  // For each unknown (a velocity of the trunk or of a hinge): the force along it; after Eliminate()
  // the momentum along it.
  std::vector<double> along_;
  bool is_eliminated_ = false;
  // The product of the inverse of L^T (see matrix_) and J^T, where J is the Jacobian of the
  // contacts.  Each call of AddRow() appends a row: one value for each unknown.  An unknown is a
  // velocity of the trunk or of a hinge.  The value for the unknown `unknown` in the row `row` is
  // row_[row * Unknowns() + unknown]; `unknown` and `row` are counted from 0.
  std::vector<double> row_;
  std::vector<double> row_scaled_;  // row_ divided by D (see matrix_), in the order of row_
  // For each call of AddRow(): UnknownOf(part), the index of the unknown that belongs to the `part`
  // of the call.  The row in row_ is 0 except at the unknowns on the path from this unknown to
  // unknown 0 (parent_).
  std::vector<int> row_unknown_;
  std::vector<double> row_speed_;  // for each call of AddRow(): the speed that FreeSpeed() returns
};

}  // namespace openr_host
