#include "openr/explore/prepared_run.h"

#include <fmt/format.h>

#include "openr/explore/explore_cost.h"
#include "openr/simulation/cost_file.h"

namespace openr_host {

PreparedRun PrepareSimulation(SimulationOptions options) {
  PreparedRun prepared;
  std::shared_ptr<ExploredCost> cost;
  if (const auto config = LoadCostFile(options.cost_file)) {
    cost = std::make_shared<ExploredCost>(*config);
    prepared.cost = cost.get();
    options.cost = cost;
  }
  options.host_network = false;
  options.writable_stick = false;
  options.measures = false;
  const auto simulation = std::make_shared<Simulation>(options);
  prepared.system = &simulation->system();
  prepared.robots = simulation->robots();
  prepared.owner = simulation;
  if (!simulation->loaded()) {
    prepared.problem = "the robot does not boot";
    for (const Finding& finding : prepared.system->findings().all()) {
      prepared.problem += fmt::format("\n{}: {}", SeverityName(finding.severity), finding.text);
    }
  }
  return prepared;
}

}  // namespace openr_host
