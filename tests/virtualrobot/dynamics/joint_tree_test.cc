// The equation of motion of a tree of parts: what physics says must stay does stay, and rows and
// impulses belong together.  ode/reference_test.cc compares the motion with that of ODE.
#include "virtualrobot/dynamics/joint_tree.h"

#include <gtest/gtest.h>

#include "tests/virtualrobot/body_harness.h"
#include "virtualrobot/dynamics/contact_forces.h"

namespace openr_host {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

Matrix3d BoxInertia(double mass_kg, const Vector3d& size_m) {
  const Vector3d squares = size_m.cwiseProduct(size_m);
  return (mass_kg / 12 * (Vector3d::Constant(squares.sum()) - squares)).asDiagonal();
}

// A trunk with two arms of two parts each, all of different masses, about different axes.
std::vector<TreePart> TwoArms() {
  const auto part = [](double mass_kg, const Vector3d& size_m, const Vector3d& centre_m, int parent,
                       const Vector3d& axis, const Vector3d& anchor_m) {
    return TreePart{.mass_kg = mass_kg,
                    .inertia_kg_m2 = BoxInertia(mass_kg, size_m),
                    .centre_m = centre_m,
                    .parent = parent,
                    .axis = axis,
                    .anchor_m = anchor_m};
  };
  return {part(0.8, {0.2, 0.1, 0.08}, {0.01, 0, 0}, -1, {0, 0, 0}, {0, 0, 0}),
          part(0.2, {0.03, 0.03, 0.1}, {0.08, 0.06, -0.05}, 0, {0, 1, 0}, {0.08, 0.05, 0}),
          part(0.1, {0.02, 0.02, 0.08}, {0.08, 0.06, -0.14}, 1, {1, 0, 0}, {0.08, 0.06, -0.1}),
          part(0.3, {0.05, 0.02, 0.06}, {-0.08, -0.06, 0.03}, 0, {0, 0, -1}, {-0.08, -0.05, 0}),
          part(0.05, {0.02, 0.02, 0.02}, {-0.1, -0.06, 0.07}, 3, {0, 1, 0}, {-0.09, -0.06, 0.06})};
}

// Hinges that turn freely.
std::vector<TorqueLine> Free(size_t parts) { return std::vector<TorqueLine>(parts); }

class JointTreeTest : public testing::Test {
 protected:
  // A step without contacts.
  void Step(double gravity_m_s2, double step_s) {
    tree_.BeginStep(Free(parts_.size()), gravity_m_s2, step_s);
    tree_.EndStep({});
  }
  void Kick() {
    tree_.BeginStep(Free(parts_.size()), 0, 0.001);
    tree_.AddForce(2, {30, 20, -10}, tree_.centre_W(2) + Vector3d(0.01, 0.02, 0));
    tree_.AddForce(4, {-5, 40, 10}, tree_.centre_W(4));
    tree_.AddTorque(0, {0.3, -0.2, 0.4});
    tree_.EndStep({});
  }

  // Momentum and angular momentum about the origin of W, of what moved from `before` to `now`.
  struct Momentum {
    Vector3d linear = Vector3d::Zero(), angular = Vector3d::Zero();
  };
  Momentum Moved(const JointTree& before, double step_s) const {
    Momentum sum;
    for (int i = 0; i < tree_.parts(); ++i) {
      const Vector3d v = (tree_.centre_W(i) - before.centre_W(i)) / step_s;
      const Matrix3d turn = tree_.R_WL(i) * before.R_WL(i).transpose();
      const Vector3d w =
          Vector3d(turn(2, 1) - turn(1, 2), turn(0, 2) - turn(2, 0), turn(1, 0) - turn(0, 1)) /
          (2 * step_s);
      const Matrix3d inertia =
          before.R_WL(i) * parts_[i].inertia_kg_m2 * before.R_WL(i).transpose();
      sum.linear += parts_[i].mass_kg * v;
      sum.angular += inertia * w + parts_[i].mass_kg * before.centre_W(i).cross(v);
    }
    return sum;
  }
  Vector3d CentreOfAll() const {
    Vector3d sum = Vector3d::Zero();
    double mass_kg = 0;
    for (int i = 0; i < tree_.parts(); ++i) {
      sum += parts_[i].mass_kg * tree_.centre_W(i);
      mass_kg += parts_[i].mass_kg;
    }
    return sum / mass_kg;
  }

  const std::vector<TreePart> parts_ = TwoArms();
  JointTree tree_{parts_};
};

TEST_F(JointTreeTest, FallsFreely) {
  const Vector3d start = CentreOfAll();
  for (int i = 0; i < 100; ++i) Step(10, 0.001);
  // A step moves with the velocity at its end, so 100 steps fall g h^2 (1 + ... + 100).
  EXPECT_NEAR(CentreOfAll().z() - start.z(), -10 * 1e-6 * 5050, 1e-12);
  for (int i = 1; i < tree_.parts(); ++i) EXPECT_NEAR(tree_.angle_rad(i), 0, 1e-12);
}

TEST_F(JointTreeTest, TumblingKeepsItsMomentum) {
  Kick();
  constexpr double kStep_s = 1e-5;
  const auto momentum = [this] {
    const JointTree before = tree_;
    Step(0, kStep_s);
    return Moved(before, kStep_s);
  };
  const Momentum start = momentum();
  EXPECT_GT(start.angular.norm(), 1e-4);
  for (int i = 0; i < 50'000; ++i) Step(0, kStep_s);  // half a second
  const Momentum end = momentum();
  EXPECT_GT(std::fabs(tree_.angle_rad(2)), 0.5);  // the hinges turn while it tumbles
  EXPECT_LT((end.linear - start.linear).norm(), 2e-4 * start.linear.norm());
  EXPECT_LT((end.angular - start.angular).norm(), 2e-3 * start.angular.norm());
}

TEST_F(JointTreeTest, RowsTellWhatImpulsesDo) {
  Kick();
  const Vector3d at = tree_.centre_W(2) + Vector3d(0, 0, -0.04);
  const auto begin = [&](JointTree* tree) {
    tree->BeginStep(Free(parts_.size()), 9.81, 0.002);
    tree->AddRow(2, at, {0, 0, 1});
    tree->AddRow(2, at, {1, 0, 0});
    tree->AddRow(4, tree->centre_W(4), {0, 1, 0});
    tree->AddRow(0, tree->centre_W(0), {0, 0.6, 0.8});
  };
  JointTree free = tree_;
  begin(&free);
  const std::vector<double> impulses = {0.02, -0.01, 0.03, 0.015};
  JointTree pushed = free;
  free.EndStep({0, 0, 0, 0});
  pushed.EndStep(impulses);
  const auto speed_of_row3 = [](const JointTree& tree) {
    return tree.v_W().dot(Vector3d(0, 0.6, 0.8));
  };
  begin(&tree_);
  EXPECT_NEAR(speed_of_row3(free), tree_.FreeSpeed(3), 1e-12);
  double change = 0;
  for (int row = 0; row < 4; ++row) {
    change += tree_.Mobility(3, row) * impulses[row];
    for (int other = 0; other < 4; ++other)
      EXPECT_NEAR(tree_.Mobility(row, other), tree_.Mobility(other, row), 1e-12);
  }
  EXPECT_NEAR(speed_of_row3(pushed) - speed_of_row3(free), change, 1e-12);
}

// A pendulum of one part on a trunk that weighs a million times as much: period 2 pi sqrt(J / mgr).
TEST(JointTreePendulumTest, SwingsWithItsPeriod) {
  std::vector<TreePart> parts(2);
  parts[0] = {.mass_kg = 1e6, .inertia_kg_m2 = 1e6 * Matrix3d::Identity()};
  parts[1] = {.mass_kg = 0.5,
              .inertia_kg_m2 = BoxInertia(0.5, {0.02, 0.02, 0.3}),
              .centre_m = {0, 0, -0.15},
              .parent = 0,
              .axis = {0, 1, 0},
              .anchor_m = {0, 0, 0}};
  JointTree tree(parts);
  tree.Place(Eigen::Isometry3d::Identity(), {0, 0.05});
  const double about_axis = 0.5 * (0.3 * 0.3 + 0.02 * 0.02) / 12 + 0.5 * 0.15 * 0.15;
  const double period_s = 2 * kPi * std::sqrt(about_axis / (0.5 * 9.81 * 0.15));
  constexpr double kStep_s = 1e-4;
  int crossings = 0, steps = 0;
  for (double last = tree.angle_rad(1); crossings < 21; ++steps) {
    tree.BeginStep(Free(2), 9.81, kStep_s);
    // A hand carries the trunk.
    tree.AddForce(0, {0, 0, 1e6 * 9.81 + 0.5 * 9.81}, tree.centre_W(0));
    tree.EndStep({});
    if ((tree.angle_rad(1) < 0) != (last < 0)) ++crossings;
    last = tree.angle_rad(1);
  }
  // 20 halves of a period lie between the first and the last crossing, a quarter before the first.
  EXPECT_NEAR(steps * kStep_s / 10.25, period_s, 1e-3 * period_s);
}

// A block of 1 kg on a slope whose angle has the tangent `slope`.  Returns its speed down the slope
// after half a second.
double SlidOn(double slope, double friction) {
  JointTree block({{.mass_kg = 1, .inertia_kg_m2 = BoxInertia(1, {0.2, 0.2, 0.02})}});
  ContactForces forces(friction);
  const double angle = DetAtan2(slope, 1);
  const Vector3d normal(std::sin(angle), 0, std::cos(angle)),
      down(std::cos(angle), 0, -std::sin(angle));
  constexpr double kStep_s = 0.002;
  for (int i = 0; i < 250; ++i) {
    block.BeginStep(Free(1), 9.81, kStep_s);
    ContactEquations equations;
    equations.Reset(4);
    for (const double x : {-0.1, 0.1}) {
      for (const double y : {-0.1, 0.1}) {
        const Vector3d corner = block.centre_W(0) + x * down + Vector3d(0, y, 0) - 0.01 * normal;
        for (const Vector3d& direction : {normal, down, Vector3d(0, 1, 0)})
          block.AddRow(0, corner, direction);
      }
    }
    for (int row = 0; row < equations.rows(); ++row) {
      equations.wanted[row] = -block.FreeSpeed(row);
      for (int column = 0; column < equations.rows(); ++column)
        equations.At(row, column) = block.Mobility(row, column);
      equations.At(row, row) += 1e-6;  // four corners share the load
    }
    block.EndStep(forces.Find(equations));
  }
  return block.v_W().dot(down);
}

TEST(JointTreeFrictionTest, BlockSlidesWhereTheSlopeIsSteeperThanTheCoefficient) {
  EXPECT_NEAR(SlidOn(0.49, 0.5), 0, 1e-3);
  const double angle = DetAtan2(0.6, 1);
  const double speed = 0.5 * 9.81 * (std::sin(angle) - 0.5 * std::cos(angle));
  EXPECT_NEAR(SlidOn(0.6, 0.5), speed, 0.01 * speed);
}

TEST(JointTreeDeathTest, AParentComesBeforeItsChild) {
  std::vector<TreePart> parts(2, {.mass_kg = 1, .inertia_kg_m2 = Matrix3d::Identity()});
  parts[1].parent = 1;
  EXPECT_DEATH(JointTree{parts}, "part 1 comes before its parent");
}

}  // namespace
}  // namespace openr_host
