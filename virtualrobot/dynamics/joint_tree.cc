#include "virtualrobot/dynamics/joint_tree.h"

#include <algorithm>
#include <cmath>

#include "runtime/base/assert.h"
#include "runtime/base/hasher.h"
#include "virtualrobot/base/det_math.h"
#include "virtualrobot/base/rotation.h"

namespace openr_host {
namespace {

using Eigen::Isometry3d;
using Eigen::Matrix3d;
using Eigen::Quaterniond;
using Eigen::Vector3d;

double Dot(const JointTree::Spatial& a, const JointTree::Spatial& b) {
  return a.angular.dot(b.angular) + a.linear.dot(b.linear);
}

// Returns the matrix that, multiplied by any vector b, gives the cross product a x b.
Matrix3d CrossMatrix(const Vector3d& a) {
  Matrix3d m;
  m << 0, -a.z(), a.y(),  //
      a.z(), 0, -a.x(),   //
      -a.y(), a.x(), 0;
  return m;
}

// Returns `q`, turned by the angular velocity `w_W` for `step_s` seconds.  Like ODE's formula, this
// formula is exact only to first order in the angle.
Quaterniond Turned(const Quaterniond& q, const Vector3d& w_W, double step_s) {
  const Vector3d half = 0.5 * step_s * w_W;
  const double w = q.w() - half.dot(q.vec());
  const Vector3d v = q.vec() + q.w() * half + half.cross(q.vec());
  // Scales the result to the length 1, because the formula gives a length above 1 if the part
  // turns.
  const double length = std::sqrt(w * w + v.squaredNorm());
  return {w / length, v.x() / length, v.y() / length, v.z() / length};
}

// Returns `vector`, shortened to the length `max` if it is longer.
Vector3d CutBack(const Vector3d& vector, double max) {
  const double length = vector.norm();
  return length > max ? Vector3d(vector * (max / length)) : vector;
}

}  // namespace

JointTree::JointTree(const std::vector<TreePart>& parts)
    : parts_(parts),
      angle_rad_(parts.size()),
      speed_rad_s_(parts.size()),
      part_states_(parts.size()),
      inertia_(parts.size()),
      force_(parts.size()) {
  for (int k = 0; k < 6; ++k) parent_.push_back(k - 1);
  for (int i = 1; i < this->parts(); ++i) {
    ASSERT(parts_[i].parent >= 0 && parts_[i].parent < i, "part {} comes before its parent", i);
    parent_.push_back(UnknownOf(parts_[i].parent));
  }
  matrix_.resize(static_cast<size_t>(Unknowns()) * Unknowns());
  along_.resize(Unknowns());
  Place(Isometry3d::Identity(), angle_rad_);
}

void JointTree::Place(const Isometry3d& X_WB, const std::vector<double>& angles_rad) {
  ASSERT(angles_rad.size() == parts_.size(), "{} angles for {} parts", angles_rad.size(),
         parts_.size());
  q_WB_ = Quaterniond(X_WB.linear());
  centre_W_ = X_WB * parts_[0].centre_m;
  v_W_ = w_W_ = Vector3d::Zero();
  angle_rad_ = angles_rad;
  speed_rad_s_.assign(parts_.size(), 0);
  PlaceParts();
}

Isometry3d JointTree::X_WL(int part) const {
  Isometry3d X;
  X.linear() = part_states_[part].R_WL;
  X.translation() = part_states_[part].centre_W - part_states_[part].R_WL * parts_[part].centre_m;
  X.makeAffine();
  return X;
}

// Computes the places of all parts of the robot from the place of its trunk and the angles of its
// hinges.
void JointTree::PlaceParts() {
  part_states_[0].R_WL = q_WB_.toRotationMatrix();
  part_states_[0].centre_W = centre_W_;
  for (int i = 1; i < parts(); ++i) {
    const TreePart& part = parts_[i];
    const TreePart& parent_part = parts_[part.parent];
    const PartState& parent = part_states_[part.parent];
    PartState& now = part_states_[i];
    now.anchor_W = parent.centre_W + parent.R_WL * (part.anchor_m - parent_part.centre_m);
    now.R_WL = parent.R_WL * AxisRotation(part.axis, angle_rad_[i]);
    now.centre_W = now.anchor_W + now.R_WL * (part.centre_m - part.anchor_m);
  }
}

// Computes the axes of the hinges, in the world frame, and the angular velocities of the parts.
void JointTree::FindMotion() {
  part_states_[0].w_W = w_W_;
  for (int i = 1; i < parts(); ++i) {
    PartState& now = part_states_[i];
    now.axis.angular = now.R_WL * parts_[i].axis;
    now.axis.linear = (now.anchor_W - centre_W_).cross(now.axis.angular);
    now.w_W = part_states_[parts_[i].parent].w_W + speed_rad_s_[i] * now.axis.angular;
  }
}

JointTree::Spatial JointTree::Inertia::MomentumAt(const Spatial& velocity) const {
  return {about_o * velocity.angular + moment.cross(velocity.linear),
          mass_kg * velocity.linear + velocity.angular.cross(moment)};
}

void JointTree::BeginStep(const std::vector<TorqueLine>& lines, double gravity_m_s2,
                          double step_s) {
  ASSERT(lines.size() == parts_.size(), "{} torque lines for {} parts", lines.size(),
         parts_.size());
  step_s_ = step_s;
  row_.clear();
  row_scaled_.clear();
  row_unknown_.clear();
  row_speed_.clear();
  is_eliminated_ = false;
  FindMotion();
  FindForces(lines, gravity_m_s2);
  FillMatrix(lines, step_s);
  Factor();
}

// Fills the lower triangle of the matrix M + h B of joint_tree.h (M: inertia, h: length of the
// step, B: by how much the torque of each servo falls when its hinge turns faster).  A part and all
// parts that it carries are taken as one body with their common inertia, because all of them move
// when the hinge of the part turns.
void JointTree::FillMatrix(const std::vector<TorqueLine>& lines, double step_s) {
  for (int i = 0; i < parts(); ++i) {
    const Vector3d r = part_states_[i].centre_W - centre_W_;
    const double mass = parts_[i].mass_kg;
    inertia_[i].mass_kg = mass;
    inertia_[i].moment = mass * r;
    const Matrix3d& R = part_states_[i].R_WL;
    inertia_[i].about_o = R * parts_[i].inertia_kg_m2 * R.transpose();
    inertia_[i].about_o.diagonal().array() += mass * r.squaredNorm();
    inertia_[i].about_o -= mass * r * r.transpose();
  }
  for (int i = parts() - 1; i > 0; --i) {
    Inertia& parent = inertia_[parts_[i].parent];
    parent.mass_kg += inertia_[i].mass_kg;
    parent.moment += inertia_[i].moment;
    parent.about_o += inertia_[i].about_o;
  }
  for (int i = 1; i < parts(); ++i) {
    const Spatial momentum = inertia_[i].MomentumAt(part_states_[i].axis);
    double* const row = RowOf(UnknownOf(i));
    for (int k = 0; k < 3; ++k) {
      row[k] = momentum.angular[k];
      row[3 + k] = momentum.linear[k];
    }
    for (int a = i; a > 0; a = parts_[a].parent)
      row[UnknownOf(a)] = Dot(part_states_[a].axis, momentum);
    row[UnknownOf(i)] += step_s * lines[i].slope_nm_s;
  }
  const Matrix3d moment = CrossMatrix(inertia_[0].moment);
  for (int k = 0; k < 3; ++k) {
    for (int a = 0; a < 3; ++a) {
      RowOf(k)[a] = inertia_[0].about_o(k, a);
      RowOf(3 + k)[a] = -moment(k, a);
      RowOf(3 + k)[3 + a] = k == a ? inertia_[0].mass_kg : 0;
    }
  }
}

// Computes the forces along the unknowns (the velocities of trunk and hinges) without pushes and
// contacts: t0 - B u - c in the equation of joint_tree.h (servos, present motion and gravity).
// First finds, from the trunk to the outermost parts, the accelerations that the parts have while
// no unknown changes.  Then finds, from the outermost parts to the trunk, the forces that these
// accelerations and gravity demand.
void JointTree::FindForces(const std::vector<TorqueLine>& lines, double gravity_m_s2) {
  struct Acceleration {
    Vector3d angular, centre;
  };
  std::vector<Acceleration> acceleration(parts_.size());
  // Lets the trunk accelerate upwards and leaves out gravity, because the parts then need the same
  // forces as with gravity on each part.
  acceleration[0] = {Vector3d::Zero(), Vector3d(0, 0, gravity_m_s2)};
  for (int i = 0; i < parts(); ++i) {
    const PartState& now = part_states_[i];
    Acceleration& own = acceleration[i];
    if (i > 0) {
      const PartState& parent = part_states_[parts_[i].parent];
      const Acceleration& before = acceleration[parts_[i].parent];
      const Vector3d to_anchor = now.anchor_W - parent.centre_W;
      const Vector3d to_centre = now.centre_W - now.anchor_W;
      own.angular = before.angular + parent.w_W.cross(Vector3d(speed_rad_s_[i] * now.axis.angular));
      own.centre = before.centre + before.angular.cross(to_anchor) +
                   parent.w_W.cross(parent.w_W.cross(to_anchor)) + own.angular.cross(to_centre) +
                   now.w_W.cross(now.w_W.cross(to_centre));
    }
    const Matrix3d& R = now.R_WL;
    const Vector3d w_L = R.transpose() * now.w_W;
    const Vector3d torque_L = parts_[i].inertia_kg_m2 * (R.transpose() * own.angular) +
                              w_L.cross(Vector3d(parts_[i].inertia_kg_m2 * w_L));
    force_[i].linear = parts_[i].mass_kg * own.centre;
    force_[i].angular = R * torque_L + Vector3d(now.centre_W - centre_W_).cross(force_[i].linear);
  }
  for (int i = parts() - 1; i > 0; --i) {
    along_[UnknownOf(i)] = lines[i].zero_speed_nm - lines[i].slope_nm_s * speed_rad_s_[i] -
                           Dot(part_states_[i].axis, force_[i]);
    force_[parts_[i].parent].angular += force_[i].angular;
    force_[parts_[i].parent].linear += force_[i].linear;
  }
  for (int k = 0; k < 3; ++k) {
    along_[k] = -force_[0].angular[k];
    along_[3 + k] = -force_[0].linear[k];
  }
}

// Factors the matrix of the equation of motion into L^T D L, with L a lower triangle with ones on
// its diagonal.  Eliminates the hinges of the outermost parts first, because then the zeros of the
// matrix (see the top of joint_tree.h) stay zeros.
void JointTree::Factor() {
  for (int k = Unknowns() - 1; k >= 0; --k) {
    double* const row = RowOf(k);
    ASSERT(row[k] > 0, "unknown {} has the inertia {}", k, row[k]);
    const double inverse = 1 / row[k];
    for (int i = parent_[k]; i >= 0; i = parent_[i]) {
      const double factor = row[i] * inverse;
      double* const other = RowOf(i);
      for (int j = i; j >= 0; j = parent_[j]) other[j] -= factor * row[j];
      // Stores the factor only after the loop over j, because this loop reads the old value of
      // row[i].
      row[i] = factor;
    }
  }
}

void JointTree::AddAlong(int part, const Spatial& force, double* along) const {
  for (int i = part; i > 0; i = parts_[i].parent)
    along[UnknownOf(i)] += Dot(part_states_[i].axis, force);
  for (int k = 0; k < 3; ++k) {
    along[k] += force.angular[k];
    along[3 + k] += force.linear[k];
  }
}

void JointTree::AddForce(int part, const Vector3d& force_W, const Vector3d& p_W) {
  ASSERT(!is_eliminated_, "a push comes after the rows");
  AddAlong(part, {Vector3d(p_W - centre_W_).cross(force_W), force_W}, along_.data());
}

void JointTree::AddTorque(int part, const Vector3d& torque_W) {
  ASSERT(!is_eliminated_, "a torque comes after the rows");
  AddAlong(part, {torque_W, Vector3d::Zero()}, along_.data());
}

// Multiplies `x` in place by the inverse of L^T (L is the result of Factor()).  REQUIRES: `x` is
// zero except at the unknowns (velocities of hinges and trunk) on the path from `unknown` to the
// trunk.
void JointTree::EliminateFrom(int unknown, double* x) const {
  for (int i = unknown; i >= 0; i = parent_[i]) {
    const double* const row = RowOf(i);
    for (int j = parent_[i]; j >= 0; j = parent_[j]) x[j] -= row[j] * x[i];
  }
}

// Begins to solve the equation of motion: multiplies the forces along the unknowns (the velocities
// of trunk and hinges) by the length of the step, and the result by the inverse of L^T (L is the
// result of Factor()).
void JointTree::Eliminate() {
  is_eliminated_ = true;
  for (double& value : along_) value *= step_s_;
  for (int i = Unknowns() - 1; i >= 0; --i) {
    const double* const row = RowOf(i);
    for (int j = parent_[i]; j >= 0; j = parent_[j]) along_[j] -= row[j] * along_[i];
  }
}

void JointTree::AddRow(int part, const Vector3d& p_W, const Vector3d& direction_W) {
  if (!is_eliminated_) Eliminate();
  const size_t begin = row_.size();
  row_.resize(begin + Unknowns());
  row_scaled_.resize(row_.size());
  double* const row = &row_[begin];
  double* const scaled = &row_scaled_[begin];
  AddAlong(part, {Vector3d(p_W - centre_W_).cross(direction_W), direction_W}, row);
  double speed = 0;
  for (int i = part; i > 0; i = parts_[i].parent) speed += row[UnknownOf(i)] * speed_rad_s_[i];
  for (int k = 0; k < 3; ++k) speed += row[k] * w_W_[k] + row[3 + k] * v_W_[k];
  EliminateFrom(UnknownOf(part), row);
  for (int i = UnknownOf(part); i >= 0; i = parent_[i]) {
    scaled[i] = row[i] / RowOf(i)[i];
    speed += scaled[i] * along_[i];
  }
  row_unknown_.push_back(UnknownOf(part));
  row_speed_.push_back(speed);
}

double JointTree::Mobility(int a, int b) const {
  const double* const one = &row_[static_cast<size_t>(a) * Unknowns()];
  const double* const other = &row_scaled_[static_cast<size_t>(b) * Unknowns()];
  double sum = 0;
  for (int i = row_unknown_[a]; i >= 0; i = parent_[i]) sum += one[i] * other[i];
  return sum;
}

void JointTree::EndStep(const std::vector<double>& impulses) {
  ASSERT(impulses.size() == row_speed_.size(), "{} impulses for {} rows", impulses.size(),
         row_speed_.size());
  if (!is_eliminated_) Eliminate();
  for (int r = 0; r < rows(); ++r) {
    const double* const row = &row_[static_cast<size_t>(r) * Unknowns()];
    for (int i = row_unknown_[r]; i >= 0; i = parent_[i]) along_[i] += row[i] * impulses[r];
  }
  // Replaces the momenta in along_ (one for each velocity of the trunk and of the hinges) by the
  // changes of these velocities, because Move() adds the changes.
  for (int i = 0; i < Unknowns(); ++i) {
    const double* const row = RowOf(i);
    along_[i] /= row[i];
    for (int j = parent_[i]; j >= 0; j = parent_[j]) along_[i] -= row[j] * along_[j];
  }
  Move();
}

// Adds along_, in which EndStep() has stored changes of velocity, to the velocities of trunk and
// hinges.  Then moves all parts with the new velocities for one step.
void JointTree::Move() {
  for (int k = 0; k < 3; ++k) {
    w_W_[k] += along_[k];
    v_W_[k] += along_[3 + k];
  }
  w_W_ = CutBack(w_W_, kTurnMax_rad_s);
  v_W_ = CutBack(v_W_, kSpeedMax_m_s);
  centre_W_ += step_s_ * v_W_;
  q_WB_ = Turned(q_WB_, w_W_, step_s_);
  for (int i = 1; i < parts(); ++i) {
    speed_rad_s_[i] =
        std::clamp(speed_rad_s_[i] + along_[UnknownOf(i)], -kTurnMax_rad_s, kTurnMax_rad_s);
    angle_rad_[i] += step_s_ * speed_rad_s_[i];
  }
  PlaceParts();
}

void JointTree::HashState(Hasher* hasher) const {
  // Collects all numbers of the state first, because one long piece of bytes is hashed faster than
  // many short pieces.
  std::vector<double> values;
  values.reserve(13 + 2 * parts_.size());
  values.insert(values.end(), q_WB_.coeffs().data(), q_WB_.coeffs().data() + 4);
  for (const Vector3d* const vector : {&centre_W_, &v_W_, &w_W_})
    values.insert(values.end(), vector->data(), vector->data() + 3);
  // Begins with part 1, because part 0 is the trunk, which has no hinge.
  values.insert(values.end(), angle_rad_.begin() + 1, angle_rad_.end());
  values.insert(values.end(), speed_rad_s_.begin() + 1, speed_rad_s_.end());
  hasher->AddBytes(values.data(), values.size() * sizeof(double));
}

}  // namespace openr_host
