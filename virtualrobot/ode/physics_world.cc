#include "virtualrobot/ode/physics_world.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "runtime/base/assert.h"
#include "runtime/base/hasher.h"
#include "runtime/base/upper_registers.h"
#include "virtualrobot/body/body.h"
#include "virtualrobot/ode/contact_finder.h"
#include "virtualrobot/ode/ode_bodies.h"
#include "virtualrobot/ode/ode_body.h"

namespace openr_host {
namespace {

using Eigen::Isometry3d;
using Eigen::Vector3d;

// Largest number of contacts that are solved together, per robot in the group.  A group has the
// robots and movable things that touch each other; a group without robots may have as many contacts
// as a group with one robot.  In a group with more contacts, only the deepest are solved, because
// the work of the solver grows with the third power of the number of contacts.
constexpr size_t kContactsPerRobot = 64;
constexpr size_t kContactsMax = 3 * kContactsPerRobot;

// Coefficient of rolling resistance of spheres and cylinders (our choice): a ball that starts with
// 0.5 m/s rolls about 0.4 m.
constexpr double kRollingResistance = 0.05;

}  // namespace

PhysicsWorld::PhysicsWorld(const World& world, const OdeSettings& settings)
    : world_(world),
      settings_(settings),
      things_(world.things),
      thing_bodies_(world.things.size()),
      forces_(world.floor_friction) {
  InitOde();
  ode_ = dWorldCreate();
  for (size_t i = 0; i < things_.size(); ++i) {
    if (things_[i].mass_kg > 0) AddMover(i);
  }
  // Takes the addresses of the trees only when movers_ is complete, because the vector moves its
  // elements when it grows.
  for (Mover& mover : movers_) trees_.push_back(&mover.tree);
  finder_ = std::make_unique<ContactFinder>(things_, thing_bodies_);
}

PhysicsWorld::~PhysicsWorld() {
  // Destroys finder_, which finds contacts, before ODE's world, because finder_ refers to bodies of
  // this world.
  finder_.reset();
  dWorldDestroy(ode_);  // destroys the world with its bodies
}

void PhysicsWorld::AddMover(size_t thing) {
  const WorldThing& data = things_[thing];
  dxBody* const body = MakeBodyOfThing(ode_, data);
  thing_bodies_[thing] = body;
  const TreePart part{.mass_kg = MassOf(body), .inertia_kg_m2 = InertiaOf(body)};
  Mover mover{thing, body, JointTree({part})};
  if (data.shape != ThingShape::kBox) {
    const double radius_m = data.size_m.x() / 2;
    mover.brake_nm = kRollingResistance * data.mass_kg * kGravity_m_s2 * radius_m;
    mover.least_inertia_kg_m2 = part.inertia_kg_m2.diagonal().minCoeff();
  }
  Isometry3d X_WT;
  X_WT.linear() = data.R_WT;
  X_WT.translation() = data.centre_m;
  X_WT.makeAffine();
  mover.tree.Place(X_WT, {0});
  movers_.push_back(std::move(mover));
  PlaceMover(&movers_.back());
}

void PhysicsWorld::AddRobot(OdeBody* robot) {
  finder_->AddRobot(static_cast<int>(trees_.size()), robot->model(), robot->ode_bodies());
  trees_.push_back(&robot->tree());
  robots_.push_back(robot);
}

void PhysicsWorld::Advance() {
  if (!std::exchange(is_awaited_, false)) return;
  for (OdeBody* const robot : robots_) robot->BeginFrame();
  for (int i = 0; i < settings_.steps_per_frame; ++i) Step(kFrame_s / settings_.steps_per_frame);
  for (OdeBody* const robot : robots_) robot->EndFrame();
}

// Moves all robots and movable things by one step of `step_s` seconds.
void PhysicsWorld::Step(double step_s) {
  // Clears the upper halves of the registers, because the code of a step uses SSE.  After AVX code
  // has run, SSE code may run at a third of its speed until these halves are cleared.
  ClearUpperRegisters();
  static const std::vector<TorqueLine> kNoLine(1);
  for (Mover& mover : movers_) mover.tree.BeginStep(kNoLine, kGravity_m_s2, step_s);
  for (OdeBody* const robot : robots_) robot->BeginStep(step_s);
  const std::vector<ContactPoint>& points = finder_->Find();
  if (!movers_.empty()) BrakeRolling(points, step_s);
  AddRows(points);
  FindGroups(points);
  for (int group = 0; group < static_cast<int>(trees_.size()); ++group) {
    if (GroupOf(group) == group) SolveGroup(points, group, step_s);
  }
  for (size_t i = 0; i < points.size(); ++i) {
    if (points[i].paw < 0) continue;
    const RowSides& normal = rows_[3 * i];
    robots_[static_cast<size_t>(normal.tree) - movers_.size()]->NotePawForce(
        points[i].paw, impulses_[normal.tree][normal.row] / kFrame_s);
  }
  for (size_t i = 0; i < trees_.size(); ++i) trees_[i]->EndStep(impulses_[i]);
  for (Mover& mover : movers_) PlaceMover(&mover);
  for (OdeBody* const robot : robots_) robot->EndStep();
}

// Brakes the rotation of spheres and cylinders that touch something, as rolling resistance does.
// The torque stops a slow rotation but never reverses it.
void PhysicsWorld::BrakeRolling(const std::vector<ContactPoint>& points, double step_s) {
  for (size_t i = 0; i < movers_.size(); ++i) {
    JointTree& tree = movers_[i].tree;
    const double speed_rad_s = tree.w_W().norm();
    const auto touches = [i](const ContactPoint& point) {
      return point.side.tree == static_cast<int>(i) || point.other.tree == static_cast<int>(i);
    };
    if (movers_[i].brake_nm == 0 || speed_rad_s == 0 || std::ranges::none_of(points, touches))
      continue;
    const double torque_nm =
        std::min(movers_[i].brake_nm, movers_[i].least_inertia_kg_m2 * speed_rad_s / step_s);
    tree.AddTorque(0, tree.w_W() * (-torque_nm / speed_rad_s));
  }
}

// Adds three rows for each contact to the trees of both sides of the contact.  A row is a direction
// in which an impulse of the contact acts: the normal, or one of two directions along the surface.
// Also tells the robots which of their paws touch something.
void PhysicsWorld::AddRows(const std::vector<ContactPoint>& points) {
  rows_.clear();
  for (const ContactPoint& point : points) {
    if (point.paw >= 0)
      robots_[static_cast<size_t>(point.side.tree) - movers_.size()]->NotePawContact(point.paw);
    const Vector3d& normal_W = point.normal_W;
    // Chooses an axis that is not nearly parallel to the normal, because the cross product would be
    // inexact otherwise.
    const Vector3d side_W = std::fabs(normal_W.x()) > 0.5 ? Vector3d::UnitY() : Vector3d::UnitX();
    const Vector3d ground_W = normal_W.cross(side_W.cross(normal_W)).normalized();
    for (const Vector3d& direction_W : {normal_W, ground_W, Vector3d(normal_W.cross(ground_W))}) {
      RowSides row;
      row.tree = point.side.tree;
      row.row = trees_[row.tree]->rows();
      trees_[row.tree]->AddRow(point.side.part, point.p_W, direction_W);
      if (point.other.tree >= 0) {
        row.other_tree = point.other.tree;
        row.other_row = trees_[row.other_tree]->rows();
        trees_[row.other_tree]->AddRow(point.other.part, point.p_W, -direction_W);
      }
      rows_.push_back(row);
    }
  }
  impulses_.resize(trees_.size());
  for (size_t i = 0; i < trees_.size(); ++i) impulses_[i].assign(trees_[i]->rows(), 0);
}

// Forms groups of trees that touch one another; a tree is a robot or a movable thing.  The number
// of a group is the lowest number of its trees.
void PhysicsWorld::FindGroups(const std::vector<ContactPoint>& points) {
  groups_.resize(trees_.size());
  for (int i = 0; i < static_cast<int>(trees_.size()); ++i) groups_[i] = i;
  for (const ContactPoint& point : points) {
    if (point.other.tree < 0) continue;
    const int a = GroupOf(point.side.tree), b = GroupOf(point.other.tree);
    // Makes the lower of the two numbers the number of both groups, because Step() looks for a tree
    // whose number is also the number of its group.
    groups_[std::max(a, b)] = std::min(a, b);
  }
}

int PhysicsWorld::GroupOf(int tree) const {
  while (groups_[tree] != tree) tree = groups_[tree];
  return tree;
}

// Finds the impulses of the contacts of a group and stores them in impulses_.  If the group has too
// many contacts, the least deep are left out and get no impulse.
void PhysicsWorld::SolveGroup(const std::vector<ContactPoint>& points, int group, double step_s) {
  contacts_of_group_.clear();
  for (size_t i = 0; i < points.size(); ++i) {
    // Tests only one side of the contact, because the other side, if it can move too, is in the
    // same group.
    if (GroupOf(points[i].side.tree) == group) contacts_of_group_.push_back(i);
  }
  size_t robots = 0;
  for (size_t tree = movers_.size(); tree < trees_.size(); ++tree)
    robots += GroupOf(static_cast<int>(tree)) == group;
  const size_t contacts_max =
      std::clamp(robots * kContactsPerRobot, kContactsPerRobot, kContactsMax);
  if (contacts_of_group_.size() > contacts_max) {
    std::stable_sort(contacts_of_group_.begin(), contacts_of_group_.end(),
                     [&](size_t a, size_t b) { return points[a].depth_m > points[b].depth_m; });
    contacts_of_group_.resize(contacts_max);
  }
  FillEquations(points, step_s);
  const std::vector<double>& found = forces_.Find(equations_);
  for (size_t i = 0; i < found.size(); ++i) {
    const RowSides& row = rows_[3 * contacts_of_group_[i / 3] + i % 3];
    impulses_[row.tree][row.row] = found[i];
    if (row.other_tree >= 0) impulses_[row.other_tree][row.other_row] = found[i];
  }
}

void PhysicsWorld::FillEquations(const std::vector<ContactPoint>& points, double step_s) {
  equations_.Reset(static_cast<int>(contacts_of_group_.size()));
  const auto row_of = [this](int row) -> const RowSides& {
    return rows_[3 * contacts_of_group_[row / 3] + row % 3];
  };
  for (int row = 0; row < equations_.rows(); ++row) {
    const RowSides& sides = row_of(row);
    equations_.wanted[row] = -trees_[sides.tree]->FreeSpeed(sides.row);
    if (sides.other_tree >= 0)
      equations_.wanted[row] -= trees_[sides.other_tree]->FreeSpeed(sides.other_row);
    if (row % 3 == 0) {
      const double depth_m = points[contacts_of_group_[row / 3]].depth_m;
      equations_.wanted[row] +=
          std::min(settings_.contact_erp * depth_m / step_s, settings_.depart_speed_m_s);
    }
    for (int column = 0; column <= row; ++column)
      equations_.At(row, column) = equations_.At(column, row) = Mobility(sides, row_of(column));
    // Makes the contact a little soft, so that the diagonal of the matrix is above 0 and the
    // equations have a solution.
    equations_.At(row, row) += settings_.contact_cfm / step_s;
  }
}

// Returns by how much an impulse of 1 N s along row `b` (a direction of a contact) changes the
// velocity along row `a`: the sum over the trees (robots or movable things) that both rows have in
// common.
double PhysicsWorld::Mobility(const RowSides& a, const RowSides& b) const {
  double sum = 0;
  if (a.tree == b.tree) sum += trees_[a.tree]->Mobility(a.row, b.row);
  if (a.tree == b.other_tree) sum += trees_[a.tree]->Mobility(a.row, b.other_row);
  if (a.other_tree < 0) return sum;
  if (a.other_tree == b.tree) sum += trees_[a.other_tree]->Mobility(a.other_row, b.row);
  if (a.other_tree == b.other_tree) sum += trees_[a.other_tree]->Mobility(a.other_row, b.other_row);
  return sum;
}

// Moves the thing and its body of ODE to the place that the JointTree of the thing has computed.
void PhysicsWorld::PlaceMover(Mover* mover) {
  WorldThing& thing = things_[mover->thing];
  thing.centre_m = mover->tree.centre_W(0);
  thing.R_WT = mover->tree.R_WL(0);
  PlaceBody(mover->body, thing.centre_m, thing.R_WT);
}

void PhysicsWorld::PutThing(size_t thing, const Vector3d& centre_m) {
  const auto mover = std::ranges::find(movers_, thing, &Mover::thing);
  ASSERT(mover != movers_.end(), "thing {} is fixed", thing);
  Isometry3d X_WT = Isometry3d::Identity();
  X_WT.linear() = world_.things[thing].R_WT;
  X_WT.translation() = centre_m;
  mover->tree.Place(X_WT, {0});
  PlaceMover(&*mover);
}

void PhysicsWorld::HashThings(Hasher* hasher) const {
  for (const Mover& mover : movers_) mover.tree.HashState(hasher);
}

}  // namespace openr_host
