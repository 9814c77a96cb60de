// What is explored: a graph of objects, put together up to System::Boot().
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
  std::vector<VirtualRobot*> robots;  // none: a graph without a body
  ExploredCost* cost = nullptr;       // null: handlers take no time
  std::shared_ptr<void> owner;        // of all of these
  std::string problem;                // why it cannot run, or ""
};

// Puts the same run together each time it is called; each worker process calls it once.
using PrepareRun = std::function<PreparedRun()>;

// A stick on a body.  Nobody writes to the stick and there is no network outside.  Throws
// std::runtime_error when it cannot be put together.
PreparedRun PrepareSimulation(SimulationOptions options);

}  // namespace openr_host
