// ContactForces: computes the impulses of contacts that obey Coulomb's law of friction.
//
// Each contact has three rows in the equations: one for its normal, which points away from the
// ground, and two for directions along the ground.  K is the mobility of the robot plus the
// softness of the contacts: impulses p along the rows change the velocities along the rows by K p.
// d is the wanted change of velocity: after it, no contact slides, and each contact leaves the
// ground at the speed that corrects its depth.  A contact obeys one of three laws:
//
//   It sticks: in its rows, K p equals d, and its impulse lies in the cone of friction.
//   It slides: along the normal, K p equals d.  Its impulse lies on the border of the cone.  Along
//     the ground, the impulse has the direction of d - K p, the velocity that is missing.
//   It opens: its impulse is 0, and it leaves the ground faster than d demands.
//
// Find() first solves the equations as if all contacts stuck, because most contacts of a robot do.
// Find() leaves out contacts that would pull at the ground.  When all impulses lie in their cones,
// they are the result.  Otherwise Find() makes sweeps, which begin from these impulses.  A sweep
// gives one contact after the other the impulse that its law demands while all other impulses stay.
// The sweeps end when no impulse changes any more.
#pragma once

#include <cstddef>
#include <vector>

namespace openr_host {

// The equations of the contacts of one step: the matrix K and the wanted changes of velocity d.
class ContactEquations {
 public:
  // Makes the equations of `contacts` contacts, with all numbers 0.
  void Reset(int contacts);

  int contacts() const { return rows() / 3; }
  int rows() const { return static_cast<int>(wanted.size()); }

  // Returns the element of the matrix K (change of velocity for each unit of impulse) at a row and
  // a column.  Contact c has the row and the column 3 c for its normal, and 3 c + 1 and 3 c + 2 for
  // its two directions of the ground.
  double& At(int row, int column) { return matrix_[static_cast<size_t>(row) * rows() + column]; }
  const double* Row(int row) const { return &matrix_[static_cast<size_t>(row) * rows()]; }

  // The wanted change of velocity for each row (one of the three directions of a contact), in m/s.
  // This is the vector d of the comment at the top of this file.
  std::vector<double> wanted;

 private:
  std::vector<double> matrix_;  // the matrix K, which is symmetric, in 1/kg
};

class ContactForces {
 public:
  // `friction` is Coulomb's coefficient of friction.
  explicit ContactForces(double friction) : friction_(friction) {}

  // Largest change of an impulse, in N s, that counts as no change.  Find() ends after a sweep over
  // all contacts in which no impulse changes by more.  For comparison: a standing ERS-210 presses
  // with 0.13 N s on the floor in a frame.
  static constexpr double kTolerance_n_s = 1e-6;
  // Limit of the number of sweeps over all contacts.  After so many sweeps Find() returns the
  // impulses as they are.
  static constexpr int kSweepsMax = 1000;

  // Solves `equations` and returns the impulse along each row, in N s.  The result is valid until
  // the next call.  REQUIRES: the matrix is symmetric and positive definite.
  const std::vector<double>& Find(const ContactEquations& equations);

  // Returns the number of sweeps that the last call of Find() made; in a sweep, each contact gets a
  // new impulse.
  int sweeps() const { return sweeps_; }

 private:
  bool SolveSticking(const ContactEquations& equations);
  void SolveClosed(const ContactEquations& equations);
  bool LiesInCone(int contact) const;
  double Sweep(const ContactEquations& equations);

  const double friction_;
  std::vector<double> impulses_;  // for each row (a direction of a contact), the impulse in N s
  std::vector<int> closed_;       // contacts that press; SolveSticking() leaves out those that pull
  // Cholesky factor, row by row, of the part of the contacts' matrix K that belongs to the contacts
  // in closed_ (those that press on the ground).
  std::vector<double> factor_;
  int sweeps_ = 0;
};

}  // namespace openr_host
