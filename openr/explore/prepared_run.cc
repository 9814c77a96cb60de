#include "openr/explore/prepared_run.h"

#include <fmt/format.h>

#include "openr/explore/explore_cost.h"
#include "openr/explore/explore_schedule.h"
#include "openr/explore/fault_line.h"
#include "openr/simulation/cost_file.h"
#include "runtime/base/assert.h"
#include "runtime/core/system.h"

namespace openr_host {

void SetSchedule(PreparedRun* prepared, uint64_t seed, ExploreSchedule* schedule, int64_t for_us) {
  prepared->system->Reseed(seed);
  prepared->system->set_schedule(schedule);
  if (prepared->cost != nullptr) prepared->cost->set_schedule(schedule);
  for (size_t i = 0; i < prepared->robots.size(); ++i) {
    const int64_t frames = for_us / kFrameUs;
    prepared->robots[i]->set_first_frame(schedule->FirstFrame(static_cast<int>(i), frames));
  }
  const int robots = static_cast<int>(prepared->robots.size());
  for (const Deviation& fault : schedule->Faults(robots, for_us)) {
    const int robot = static_cast<int>(fault.selector);
    const RobotModel& model = prepared->robots.at(fault.selector)->model();
    const std::string problem =
        prepared->system->inputs().AddAt(fault.time_us, robot, FaultLine(model, fault.us));
    ASSERT(problem.empty(), "{}", problem);
  }
}

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
  // An exploration writes no report, so handler times and stacks are not measured.
  options.measures_handlers = false;
  const auto simulation = std::make_shared<Simulation>(options);
  prepared.simulation = simulation.get();
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
