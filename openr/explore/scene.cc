#include "openr/explore/scene.h"

#include <fmt/format.h>

#include "openr/cost_file.h"
#include "openr/explore/explore_cost.h"

namespace openr_host {

Scene MakeSimulationScene(SimulationOptions options) {
  Scene scene;
  std::shared_ptr<ExploredCost> cost;
  if (const auto config = LoadCostFile(options.cost_file)) {
    cost = std::make_shared<ExploredCost>(*config);
    scene.cost = cost.get();
    options.cost = cost;
  }
  options.host_network = false;
  options.writable_stick = false;
  options.measures = false;
  const auto simulation = std::make_shared<Simulation>(options);
  scene.system = &simulation->system();
  scene.robots = simulation->robots();
  scene.owner = simulation;
  if (!simulation->loaded()) {
    scene.problem = "the robot does not boot";
    for (const Finding& finding : scene.system->findings().all()) {
      scene.problem += fmt::format("\n{}: {}", SeverityName(finding.severity), finding.text);
    }
  }
  return scene;
}

}  // namespace openr_host
