// DistributedRun connects a run with other processes: with workers, which run some of the objects,
// with ROS 2 and with openr top.  Without the flags for these processes it does nothing.
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

// The connections of one run to other processes.  The caller calls the functions in the order in
// which they are declared here.  The simulation calls back into this object, so the object must
// outlive the simulation.
class DistributedRun {
 public:
  // Starts the worker processes of this host, which run the objects that `placement` gives them.
  // The workers read the Memory Stick `stick`, and a worker ends when a handler uses more than
  // `handler_limit_us` of processor time.  `interrupts` counts how often the user has pressed
  // Ctrl-C, and must outlive this object.  Throws CLI::ValidationError if the flags are wrong, and
  // std::runtime_error if DDS, the network to the other processes, fails.
  DistributedRun(const PlacementFlags& placement, const Ros2Flags& ros2, const RunStick& stick,
                 int64_t handler_limit_us, const InterruptCounter* interrupts);

  bool has_processes() const { return workers_ != nullptr; }

  // Changes `options`, from which the caller then makes the simulation.  Adds functions that make a
  // stand-in for each object that runs in a worker.  With --ros2, also adds a JointClient to each
  // robot's network; the JointClient sends the commands of ROS 2 to the robot.  `say` prints
  // messages about ROS 2 for the user.
  void ChangeOptions(SimulationOptions* options, const Ros2Link::Say& say);

  // Throws std::runtime_error if the flags --place, --placement or --isolate name an object that
  // the stick does not have, or that cannot run in a worker.  Called when the simulation has loaded
  // all objects, because their names are not known before.
  void CheckPlaces() const;

  // Sends each worker process the list of the run's robots and objects, and waits until the worker
  // has loaded its own objects.  Returns "", or why a worker has not loaded them.
  std::string Connect(Simulation* simulation);

  // Returns the first problem that a worker has had so far; "" if there is none.  The caller calls
  // it in place of Connect() when the run ends before all workers are ready.
  std::string Problem() const;

  // Begins to exchange data with ROS 2 and openr top, and sets the functions in `plan` that handle
  // these data during the run.  REQUIRES: plan->recorder is set, because the recorder must learn
  // when a worker is lost; no Runner has been made from `plan`, because a Runner keeps a copy of
  // `plan`.
  void Begin(Simulation* simulation, RunPlan* plan);

  // Sends the last status of the run to openr top.  With --ros2, prints how many messages about ROS
  // 2 were not shown to the user during the run.
  void RunIsOver();

  // Adds warnings to the run's report about messages that were not delivered because a worker
  // process had ended.
  void ReportLosses();

  // Shortens the time limits for answers of workers.  Called when the run ends because an object
  // has crashed or a handler has run too long, so that the report is written soon.
  void ShortenTimeouts();

  // Adds a description of each worker to `report`, which is the report of the run.  The description
  // has the objects of the worker, its losses and the times of its handlers.  Does nothing without
  // workers.
  void Describe(nlohmann::ordered_json* report) const;

  // Ends the worker processes that run objects of this run.
  void EndProcesses();

  // Drops what this object has of the simulation.  Called when the simulation is about to be
  // destroyed, also if an exception has ended the run before EndProcesses().
  void ReleaseSimulation();

 private:
  void AfterFrame();

  const bool is_free_;
  const Ros2Flags ros2_flags_;
  // The worker processes; null: all objects are in this process.
  const std::unique_ptr<WorkerGroup> workers_;
  // The connection to DDS of this process; null: DDS is not used, or `workers_` has the connection.
  std::unique_ptr<Bus> own_bus_;
  Bus* bus_ = nullptr;  // the connection to DDS that is used; null: DDS is not used
  std::unique_ptr<Ros2Link> ros2_;
  std::unique_ptr<Monitor> monitor_;
};

// Makes a DistributedRun drop what it has of the simulation.  Declared behind the simulation, so
// that this happens before the simulation is destroyed, also if an exception ends the run.
class SimulationRelease {
 public:
  explicit SimulationRelease(DistributedRun* distribution) : distribution_(distribution) {}
  ~SimulationRelease() { distribution_->ReleaseSimulation(); }
  SimulationRelease(const SimulationRelease&) = delete;
  SimulationRelease& operator=(const SimulationRelease&) = delete;

 private:
  DistributedRun* const distribution_;
};

}  // namespace openr_host
