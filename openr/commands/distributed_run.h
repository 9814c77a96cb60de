// The parts of a run outside its own process: workers, ROS 2, listeners of its status.  Without the
// flags of these parts nothing is done.
#pragma once

#include <cstdint>
#include <memory>
#include <nlohmann/json_fwd.hpp>
#include <string>

#include "distribution/monitor.h"
#include "openr/commands/distribution_flags.h"
#include "openr/ros2/ros2_link.h"
#include "openr/run/runner.h"
#include "openr/simulation/simulation.h"

namespace openr_host {

class InterruptCounter;
class RunStick;

// The outside parts of one run.  The functions are called in the order of their declarations.  The
// object must outlive the simulation.
class DistributedRun {
 public:
  // Starts the workers of this host.  `interrupts` must outlive this object.  Throws
  // CLI::ValidationError, or std::runtime_error of DDS.
  DistributedRun(const PlacementFlags& placement, const Ros2Flags& ros2, const RunStick& stick,
                 int64_t handler_limit_us, const InterruptCounter* interrupts);

  bool has_processes() const { return workers_ != nullptr; }

  // Adds the stand-ins and ROS 2 to the options of a simulation that is not made yet.
  void Enter(SimulationOptions* options, const Ros2Link::Say& say);

  // Checks the placement when the simulation is loaded.  Throws std::runtime_error if the placement
  // names an unknown object.
  void CheckPlaces() const;

  // Sends the rest of the tables to all workers.  Returns false after an error message.
  bool Connect(Simulation* simulation);

  // Connects ROS 2 and the listeners, and sets the functions of `plan`.  Called before the runner
  // of `plan` is made.
  void Begin(Simulation* simulation, RunPlan* plan);

  // Publishes the final status, and prints how many complaints about ROS 2 commands were left out.
  void RunIsOver();

  // Adds findings about messages that arrived for lost workers.
  void ReportLosses();

  // Shortens the times for which workers are waited for.  Called when the run is being brought down
  // and still needs a report.
  void ShortenTimeouts();

  // Adds the workers, if there are any, to the report.
  void Describe(nlohmann::ordered_json* report) const;

  // Ends the workers.
  void EndProcesses();

 private:
  void AfterFrame();

  const bool is_free_;
  const Ros2Flags ros2_flags_;
  const std::unique_ptr<WorkerGroup> workers_;  // null: all objects are in this process
  std::unique_ptr<Bus> own_bus_;                // used without workers
  Bus* bus_ = nullptr;                          // null: DDS is not used
  std::unique_ptr<Ros2Link> ros2_;
  std::unique_ptr<Monitor> monitor_;
};

}  // namespace openr_host
