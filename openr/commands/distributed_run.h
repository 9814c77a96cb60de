// What a run has beyond its own process: processes for some of its objects, ROS 2, those who watch
// it.  Nothing at all, unless flags ask for it.
#pragma once

#include <cstdint>
#include <memory>
#include <nlohmann/json_fwd.hpp>
#include <string>

#include "distribution/monitor.h"
#include "openr/commands/distribution_flags.h"
#include "openr/ros2/ros2_link.h"
#include "openr/runner.h"
#include "openr/simulation.h"

namespace openr_host {

class InterruptCounter;
class RunStick;

// In the order of its functions.  Outlives the simulation.
class DistributedRun {
 public:
  // Starts the processes of this host.  `interrupts` outlives this.  Throws CLI::ValidationError,
  // or std::runtime_error of DDS.
  DistributedRun(const PlacementFlags& placement, const Ros2Flags& ros2, const RunStick& stick,
                 int64_t handler_limit_us, const InterruptCounter* interrupts);

  bool has_processes() const { return workers_ != nullptr; }

  // Takes its places in a simulation that is still to be made.
  void Enter(SimulationOptions* options, const Ros2Link::Say& say);

  // The simulation is loaded.  Throws std::runtime_error when an object of the placement is not
  // there.
  void CheckPlaces() const;

  // All processes hear the rest.  False after a complaint.
  bool Connect(Simulation* simulation);

  // Before the runner of `plan` is made.
  void Begin(Simulation* simulation, RunPlan* plan);

  // Whoever watches hears it, and people what they were spared.
  void RunIsOver();

  // Findings about messages that nobody heard.
  void ReportLosses();

  // Something brings the run down, and a report is still to be made: no process is waited for long.
  void ShortenTimeouts();

  // Adds what is known of the processes to the report, if there are any.
  void Describe(nlohmann::ordered_json* report) const;

  // They may end.
  void EndProcesses();

 private:
  void AfterFrame();

  const bool is_free_;
  const Ros2Flags ros2_flags_;
  const std::unique_ptr<WorkerGroup> workers_;  // null: all is in this process
  std::unique_ptr<Bus> own_bus_;                // without a workers
  Bus* bus_ = nullptr;                          // null: nobody is spoken to
  std::unique_ptr<Ros2Link> ros2_;
  std::unique_ptr<Monitor> monitor_;
};

}  // namespace openr_host
