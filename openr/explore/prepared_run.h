// A prepared run: a graph of objects, assembled up to the point before System::Boot().
#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "openr/simulation/simulation.h"

namespace openr_host {

class ExploredCost;

struct PreparedRun {
  System* system = nullptr;
  std::vector<VirtualRobot*> robots;  // empty: a graph without a body
  ExploredCost* cost = nullptr;       // null: handlers take no time
  std::shared_ptr<void> owner;        // keeps all of these alive
  std::string problem;                // the reason why it cannot run, or ""
};

// Assembles the same run each time it is called.  Each explorer process calls it once.
using PrepareRun = std::function<PreparedRun()>;

// Assembles the run of a stick on a robot with a body.  Objects cannot write to the stick, and
// there is no network outside.  Throws std::runtime_error when it cannot be assembled.
PreparedRun PrepareSimulation(SimulationOptions options);

}  // namespace openr_host
