#include "virtualrobot/dynamics/contact_forces.h"

#include <algorithm>
#include <cmath>

#include "runtime/base/assert.h"

namespace openr_host {
namespace {

// Largest number of attempts to solve the equations of all contacts at once, under the assumption
// that no contact slides.  Each attempt leaves out the contacts that pulled at the ground in the
// attempt before.  If all attempts fail, the contacts are solved one after the other (Sweep()).
constexpr int kMaxRounds = 3;

double Length(double x, double y) { return std::sqrt(x * x + y * y); }

// Returns the part of the wanted change of velocity in row `row` (one direction of a contact) that
// the impulses do not give.
double Missing(const ContactEquations& equations, const std::vector<double>& impulses, int row) {
  double missing = equations.wanted[row];
  const double* const k = equations.Row(row);
  for (int i = 0; i < equations.rows(); ++i) missing -= k[i] * impulses[i];
  return missing;
}

// The impulse of a contact along the two directions of the ground, in N s.
struct Friction {
  double x, y;
};

// Returns the next impulse of a contact along the ground, after the impulse `now`.  `missing` is
// the change of velocity that is still needed to stop the sliding.  The matrix (a, b; b, c) is the
// part of the matrix K for this contact: it gives the change of velocity that an impulse causes.
// If an impulse not longer than `max` stops the sliding, returns this impulse.  Otherwise the
// contact slides; makes one step of the search for its impulse, and shortens the result to `max` if
// it is longer.
Friction NextFriction(const Friction& now, double a, double b, double c, const Friction& missing,
                      double max) {
  const double det = a * c - b * b;
  const Friction stick{now.x + (missing.x * c - missing.y * b) / det,
                       now.y + (missing.y * a - missing.x * b) / det};
  if (Length(stick.x, stick.y) <= max) return stick;
  // The contact slides, so its impulse must have the length `max` and the direction of `missing`.
  // Each call makes one step along `missing`, and shortens the result to `max` if it is longer.
  // Repeated steps end where the impulse and `missing` have one direction.  The factor of a step is
  // 1 divided by the largest eigenvalue of the matrix (a, b; b, c), the largest factor that does
  // not overshoot.
  const double half = (a - c) / 2;
  const double step = 1 / ((a + c) / 2 + Length(half, b));
  const Friction slide{now.x + step * missing.x, now.y + step * missing.y};
  const double length = Length(slide.x, slide.y);
  if (length <= max) return slide;
  return {slide.x * (max / length), slide.y * (max / length)};
}

}  // namespace

void ContactEquations::Reset(int contacts) {
  wanted.assign(3 * static_cast<size_t>(contacts), 0);
  matrix_.assign(wanted.size() * wanted.size(), 0);
}

const std::vector<double>& ContactForces::Find(const ContactEquations& equations) {
  sweeps_ = 0;
  impulses_.assign(equations.rows(), 0);
  if (SolveSticking(equations)) return impulses_;
  for (int c = 0; c < equations.contacts(); ++c) {
    // Begins the search with the impulses of the last attempt, but without those that pull, because
    // the ground cannot pull.
    if (impulses_[3 * c] < 0) std::fill_n(&impulses_[3 * c], 3, 0.0);
  }
  while (sweeps_ < kSweepsMax && Sweep(equations) > kTolerance_n_s) ++sweeps_;
  return impulses_;
}

bool ContactForces::LiesInCone(int contact) const {
  const double* const p = &impulses_[3 * contact];
  return p[0] >= 0 && Length(p[1], p[2]) <= friction_ * p[0];
}

// Solves the equations under the assumption that no contact slides.  Leaves out contacts that would
// pull at the ground.  Returns whether the impulses obey Coulomb's law of friction at all contacts,
// so that the assumption was right.
bool ContactForces::SolveSticking(const ContactEquations& equations) {
  closed_.resize(equations.contacts());
  for (int c = 0; c < equations.contacts(); ++c) closed_[c] = c;
  for (int round = 0; round < kMaxRounds; ++round) {
    SolveClosed(equations);
    // Tries again without the contacts that pulled, because the impulses of the other contacts
    // change when these contacts are left out.
    if (std::erase_if(closed_, [this](int c) { return impulses_[3 * c] < 0; }) > 0) continue;
    for (int c = 0; c < equations.contacts(); ++c) {
      const bool is_closed = std::binary_search(closed_.begin(), closed_.end(), c);
      if (is_closed ? !LiesInCone(c) : Missing(equations, impulses_, 3 * c) > 0) return false;
    }
    return true;
  }
  return false;
}

// Solves the equations of the contacts in closed_ (those that press) by Cholesky's method, and sets
// all other impulses to 0.  Does not use Eigen for this, because Eigen chooses the order of its
// sums by the size of the processor's caches, so the last bits would depend on the processor.
void ContactForces::SolveClosed(const ContactEquations& equations) {
  const int n = 3 * static_cast<int>(closed_.size());
  const auto row_of = [this](int i) { return 3 * closed_[i / 3] + i % 3; };
  factor_.resize(static_cast<size_t>(n) * n);
  std::fill(impulses_.begin(), impulses_.end(), 0);
  for (int i = 0; i < n; ++i) {
    double* const own = &factor_[static_cast<size_t>(i) * n];
    const double* const k = equations.Row(row_of(i));
    double value = equations.wanted[row_of(i)];
    for (int j = 0; j <= i; ++j) {
      const double* const other = &factor_[static_cast<size_t>(j) * n];
      double sum = k[row_of(j)];
      for (int m = 0; m < j; ++m) sum -= own[m] * other[m];
      if (j < i) {
        own[j] = sum / other[j];
        value -= own[j] * impulses_[row_of(j)];
      } else {
        ASSERT(sum > 0, "row {} of the contacts has the mobility {}", row_of(i), sum);
        own[i] = std::sqrt(sum);
      }
    }
    impulses_[row_of(i)] = value / own[i];
  }
  for (int i = n - 1; i >= 0; --i) {
    double value = impulses_[row_of(i)];
    for (int m = i + 1; m < n; ++m)
      value -= factor_[static_cast<size_t>(m) * n + i] * impulses_[row_of(m)];
    impulses_[row_of(i)] = value / factor_[static_cast<size_t>(i) * n + i];
  }
}

// Gives one contact after the other the impulse that Coulomb's law of friction demands while all
// other impulses stay.  Returns the largest change of an impulse.
double ContactForces::Sweep(const ContactEquations& equations) {
  double largest = 0;
  for (int c = 0; c < equations.contacts(); ++c) {
    const int n = 3 * c;
    const double* const k0 = equations.Row(n) + n;
    const double* const k1 = equations.Row(n + 1) + n;
    const double* const k2 = equations.Row(n + 2) + n;
    double* const p = &impulses_[n];
    const double press = std::max(0.0, p[0] + Missing(equations, impulses_, n) / k0[0]);
    const double change = press - p[0];
    // Computes the friction that is missing after the impulse along the normal has changed by
    // `change`, because that change also changes the speed along the ground.
    const Friction missing{Missing(equations, impulses_, n + 1) - k1[0] * change,
                           Missing(equations, impulses_, n + 2) - k2[0] * change};
    const Friction friction =
        NextFriction({p[1], p[2]}, k1[1], k1[2], k2[2], missing, friction_ * press);
    largest = std::max(
        {largest, std::fabs(change), std::fabs(friction.x - p[1]), std::fabs(friction.y - p[2])});
    p[0] = press;
    p[1] = friction.x;
    p[2] = friction.y;
  }
  return largest;
}

}  // namespace openr_host
