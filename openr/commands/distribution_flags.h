// Flags of runs in several processes: openr run and openr join.
#pragma once

#include <CLI/CLI.hpp>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "distribution/bus.h"
#include "distribution/worker_group.h"

namespace openr_host {

class RunStick;

// Adds --dds-domain, --dds-address, --dds-peer and --dds-config.
void AddBusFlags(CLI::App* command, BusOptions* bus);

// Validates --run-name and --process; `what` is "run" or "process".
CLI::Validator IsNameOf(const std::string& what);

struct PlacementFlags {
  std::vector<std::string> places;  // each "OBJECT=PROCESS"
  std::string file;
  std::vector<std::string> isolated;  // names of objects
  std::string wrapper;                // command line of a debugger
  bool is_free = false;
  bool is_monitored = false;  // publishes its status also without workers
  BusOptions bus;
  int64_t wait_us = 60'000'000;
  int restarts = 0;
  std::vector<const CLI::Option*> of_processes;  // flags without effect in a run of one process
  std::vector<const CLI::Option*> of_dds;        // flags without effect in a run without DDS
};

// Adds --place, --placement, --isolate, --wrap, --monitor, --run-name, --join-wait and the flags of
// AddBusFlags().
void AddPlacementFlags(CLI::App* command, PlacementFlags* flags);

// Throws CLI::ValidationError if a flag was given that has no effect, either because the run has no
// other processes or because it does not use DDS.
void RefuseIdleFlags(const PlacementFlags& flags, bool has_processes, bool has_dds);

// The flags --ros2 and --ros2-namespace.
struct Ros2Flags {
  bool is_on = false;
  std::string space = "aibo";  // the namespace
};
void AddRos2Flags(CLI::App* command, Ros2Flags* flags);

// Starts the workers that the placement requires.  Returns null when all objects are in this
// process.  Throws CLI::ValidationError.
std::unique_ptr<WorkerGroup> MakeWorkerGroup(const PlacementFlags& flags, const RunStick& stick,
                                             int64_t handler_limit_us,
                                             std::function<int()> interrupts);

// Makes the bus of a run that has no workers and uses DDS.
std::unique_ptr<Bus> MakeBus(const PlacementFlags& flags);

}  // namespace openr_host
