// Quantities: values of a run that have names, such as the state of an object or the angle of a
// joint.  Property files can use these names.
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <variant>
#include <vector>

#include "openr/explore/property.h"

namespace openr_host {

using Value = std::variant<double, std::string>;
using Quantity = std::function<Value(const RunView&)>;

// Returns a function that reads the quantity `name` (docs/exploring.md), such as
// "objects.JointMover.state" or "robots[0].joint.LF_j1".  A name without "robots[N]." is a quantity
// of robot 0.  Throws std::runtime_error when the name is not known in `view`.  If a robot has
// booted again without loading an object again, the state of this object is "absent" and its
// numbers are NaN.
Quantity FindQuantity(const std::string& name, const RunView& view);

// Returns the names of all quantities of robots that are numbers: those of a robot's base (its
// place, attitude and speeds), the battery, the joints, the sensors and the movable things.  The
// names for robot 0 have no "robots[0]." in front.
std::vector<std::string> NumbersOf(const RunView& view);

// Returns the names of all quantities that FindQuantity() knows in `view`.  The names for robot 0
// have no "robots[0]." in front.
std::vector<std::string> QuantitiesOf(const RunView& view);

// Returns the long names of the quantities of robot 0, which begin with "robots[0].".
std::vector<std::string> LongNamesOf(const RunView& view);

// The parts of a run of a Simulation that quantities can read.
class SimulationView {
 public:
  explicit SimulationView(Simulation* simulation);
  // Forbids copies, because a copy would refer to the members of the original.
  SimulationView(const SimulationView&) = delete;
  SimulationView& operator=(const SimulationView&) = delete;

  // Finds out whether each robot stands.  Does this only for the first call in a frame of 8 ms,
  // because a StandingMonitor must look at the robot once per frame.
  void Sample();
  const RunView& run() const { return run_; }

 private:
  PreparedRun prepared_;
  std::vector<StandingMonitor> standing_;
  RunView run_;
  int64_t frame_ = -1;
};

}  // namespace openr_host
