// DistributedRun: the parts of a run outside its own process, which are workers, ROS 2 and openr
// top.  Without the flags for these parts it does nothing.
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

// The parts of one run outside its process.  The caller calls the functions in the order in which
// they are declared here.  The object must outlive the simulation.
class DistributedRun {
 public:
  // Starts the worker processes of this host, which run some of the objects.  `interrupts` must
  // outlive this object.  Throws CLI::ValidationError for wrong flags, std::runtime_error when DDS
  // fails.
  DistributedRun(const PlacementFlags& placement, const Ros2Flags& ros2, const RunStick& stick,
                 int64_t handler_limit_us, const InterruptCounter* interrupts);

  bool has_processes() const { return workers_ != nullptr; }

  // Adds to the options of a simulation, before it is made: objects that stand in for those of
  // worker processes, and the clients through which ROS 2 sends commands.
  void Enter(SimulationOptions* options, const Ros2Link::Say& say);

  // Throws std::runtime_error if the placement names an object that the stick does not have.
  // Called when the simulation has loaded all objects.
  void CheckPlaces() const;

  // Sends the worker processes all objects of the run that they do not know yet, and waits until
  // they are ready.  Returns false after printing an error.
  bool Connect(Simulation* simulation);

  // Connects ROS 2 and openr top to the simulation, and sets functions in `plan`.  Called before
  // the Runner gets `plan`.
  void Begin(Simulation* simulation, RunPlan* plan);

  // Sends the last status to openr top, and ends ROS 2, which prints how many complaints about
  // commands were left out.
  void RunIsOver();

  // Adds findings about messages that were lost because a worker process had ended.
  void ReportLosses();

  // Shortens the time limits for answers of workers.  Called when a crash or a handler limit ends
  // the run, so that the report is written soon.
  void ShortenTimeouts();

  // Adds facts about the workers to the report; nothing without workers.
  void Describe(nlohmann::ordered_json* report) const;

  // Ends the worker processes.
  void EndProcesses();

 private:
  void AfterFrame();

  const bool is_free_;
  const Ros2Flags ros2_flags_;
  const std::unique_ptr<WorkerGroup> workers_;  // null: all objects are in this process
  std::unique_ptr<Bus> own_bus_;                // set if DDS is used without workers
  Bus* bus_ = nullptr;                          // null: DDS is not used
  std::unique_ptr<Ros2Link> ros2_;
  std::unique_ptr<Monitor> monitor_;
};

}  // namespace openr_host
