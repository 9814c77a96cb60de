// A prepared run: a robot and the objects that run on it, assembled but not started yet
// (System::Boot() has not been called).
#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "openr/simulation/simulation.h"

namespace openr_host {

class ExploredCost;
class ExploreSchedule;

struct PreparedRun {
  System* system = nullptr;
  // The simulation; null: the objects were not loaded from a stick.
  Simulation* simulation = nullptr;
  std::vector<VirtualRobot*> robots;  // the robots; empty: the objects have no simulated body
  ExploredCost* cost = nullptr;       // the costs of handlers; null: handlers take no time
  // Owns the system, the robots and `cost`, which are destroyed together with the last copy of this
  // pointer.
  std::shared_ptr<void> owner;
  std::string problem;  // reason why the run cannot start; "": the run can start
};

// A function that assembles the same run each time it is called.  Each child process of the
// explorer calls it once.
using PrepareRun = std::function<PreparedRun()>;

// Lets `schedule` decide all that an exploration may vary in a run of at most `for_us`: the order
// and the delays of messages, the costs of handlers, the first frames and the faults.  `schedule`
// must exist as long as the run.  The random numbers of the simulation follow from `seed`.
void SetSchedule(PreparedRun* prepared, uint64_t seed, ExploreSchedule* schedule, int64_t for_us);

// Assembles a run of the objects on a Memory Stick, on a robot with a simulated body.  The objects
// cannot write to the stick and cannot reach the network of the host.  Throws std::runtime_error
// when the run cannot be assembled.
PreparedRun PrepareSimulation(SimulationOptions options);

}  // namespace openr_host
