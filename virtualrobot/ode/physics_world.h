// A world with physics: the floor and the fixed things, the things that move, and the robots.
//
// All that moves is a tree of parts (dynamics/joint_tree.h); a thing is a tree of one part.  In
// each step the trees that touch one another form a group, and the impulses of a group's contacts
// are found together (dynamics/contact_forces.h).  Groups that do not touch have no effect on each
// other, so a robot moves as if it were alone until something reaches it.
#pragma once

#include <Eigen/Geometry>
#include <memory>
#include <string>
#include <vector>

#include "virtualrobot/dynamics/contact_forces.h"
#include "virtualrobot/dynamics/joint_tree.h"
#include "virtualrobot/dynamics/servo.h"
#include "virtualrobot/worlds/world.h"

// ODE's world and body.  They are declared here because only virtualrobot/ode includes ODE's
// headers.
struct dxWorld;
struct dxBody;

namespace openr_host {

class ContactFinder;
class Hasher;
class OdeBody;
struct ContactPoint;

// Parameters of the simulation.  Every run of the program has the defaults; tests may use others.
struct OdeSettings {
  int steps_per_frame = 1;
  double contact_erp = 0.2;       // share of a contact's depth that is corrected in one step
  double contact_cfm = 2e-3;      // softness of contacts, in m/s per N, in all directions
  double depart_speed_m_s = 0.5;  // highest speed at which a contact's depth is corrected
  ServoSettings servo;
};

class PhysicsWorld {
 public:
  explicit PhysicsWorld(const World& world, const OdeSettings& settings = {});
  ~PhysicsWorld();
  PhysicsWorld(const PhysicsWorld&) = delete;
  PhysicsWorld& operator=(const PhysicsWorld&) = delete;

  const World& world() const { return world_; }
  const OdeSettings& settings() const { return settings_; }
  dxWorld* ode() const { return ode_; }

  // Returns the things of the world in their present places, in the order of World::things.
  const std::vector<WorldThing>& things() const { return things_; }
  const std::vector<OdeBody*>& robots() const { return robots_; }

  // Adds a robot, which must outlive the world's last Advance().
  void AddRobot(OdeBody* robot);

  // Prepares for a frame, which the next Advance() simulates.  Every robot of the world calls this
  // when it gets its commands; the calls after the first change nothing.
  void AwaitFrame() { is_awaited_ = true; }

  // Simulates a frame of 8 ms, with all robots and things.  Only the first call after
  // AwaitFrame() does so, because each robot of the world calls this function in each frame.
  void Advance();

  // Puts the movable thing `thing`, an index of World::things, at rest at `centre_m`, turned as in
  // the world file.
  void PutThing(size_t thing, const Eigen::Vector3d& centre_m);

  // Adds the motion of the movable things to `hasher`.
  void HashThings(Hasher* hasher) const;

 private:
  // A thing of the world that can move.
  struct Mover {
    size_t thing;  // index of the thing in World::things
    dxBody* body;
    JointTree tree;
    // Limits of the torque that brakes the rotation of the thing.  The torque is at most brake_nm.
    // The torque is also at most that which stops, in one step, a thing with the inertia
    // least_inertia_kg_m2.  This is the least inertia of the thing about any of its axes, so the
    // torque never reverses a rotation.
    double brake_nm = 0, least_inertia_kg_m2 = 0;
  };

  // The position of a row of the equations in the trees on the two sides of its contact: for each
  // side, the number of the tree and the number of the row in this tree.
  struct RowSides {
    int tree = -1, row = 0;
    int other_tree = -1, other_row = 0;  // the contact's other side; other_tree -1: not movable
  };

  void AddMover(size_t thing);
  void Step(double step_s);
  void BrakeRolling(const std::vector<ContactPoint>& points, double step_s);
  void AddRows(const std::vector<ContactPoint>& points);
  void FindGroups(const std::vector<ContactPoint>& points);
  int GroupOf(int tree) const;
  void SolveGroup(const std::vector<ContactPoint>& points, int group, double step_s);
  void FillEquations(const std::vector<ContactPoint>& points, double step_s);
  double Mobility(const RowSides& a, const RowSides& b) const;
  void PlaceMover(Mover* mover);

  const World world_;
  const OdeSettings settings_;
  std::vector<WorldThing> things_;
  dxWorld* ode_;
  std::vector<dxBody*> thing_bodies_;  // bodies of ODE, in the order of World::things; null: fixed
  std::vector<Mover> movers_;
  std::vector<OdeBody*> robots_;
  std::vector<JointTree*> trees_;  // all trees: first those of movers_, then those of robots_
  std::unique_ptr<ContactFinder> finder_;
  bool is_awaited_ = false;

  // The members below belong to the present step of the physics.
  std::vector<RowSides> rows_;  // three rows of the equations for each contact
  // The groups of the trees.  A tree is a robot or a movable thing, and trees that touch each other
  // form a group.  groups_[tree] is `tree` itself, or the lower number of another tree in the same
  // group.  GroupOf() follows these numbers to the lowest number of the group.
  std::vector<int> groups_;
  std::vector<size_t> contacts_of_group_;  // contacts of the group that SolveGroup() solves
  // The impulses of the contacts in the present step: impulses_[tree][row of the tree].  A tree is
  // a robot or a movable thing, a row is a direction of a contact.
  std::vector<std::vector<double>> impulses_;
  ContactEquations equations_;
  ContactForces forces_;
};

}  // namespace openr_host
