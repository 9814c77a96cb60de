// Flags for runs with several processes; openr run, openr join and openr top have them.
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

// Adds the flags for DDS, the network between the processes of a run: --dds-domain, --dds-address,
// --dds-peer, --dds-lease and --dds-config.
void AddBusFlags(CLI::App* command, BusOptions* bus);

// Returns a check of the value of --run-name (`what` is "run") or --process (`what` is "process"):
// it accepts only names of up to 64 letters, digits, '_', '-' and '.'.
CLI::Validator IsNameOf(const std::string& what);

struct PlacementFlags {
  std::vector<std::string> places;  // values of --place, each "OBJECT=PROCESS"
  std::string file;
  std::vector<std::string> isolated;  // names of objects, each of which gets a process of its own
  std::string wrapper;                // command that starts workers, such as "gdb --args"
  bool is_free = false;
  // True: the run sends its status to openr top, even if it has no workers.
  bool is_monitored = false;
  BusOptions bus;
  int64_t wait_us = 60'000'000;
  int restarts = 0;
  // Flags that have no effect if all objects run in this process; RefuseIdleFlags() then refuses
  // these flags.
  std::vector<const CLI::Option*> of_processes;
  std::vector<const CLI::Option*> of_dds;  // flags that have no effect if the run does not use DDS
};

// Adds the flags for runs in several processes: --place, --placement, --isolate, --wrap,
// --free-running, --restart, --monitor, --run-name, --join-wait and the flags of AddBusFlags().
void AddPlacementFlags(CLI::App* command, PlacementFlags* flags);

// Throws CLI::ValidationError if the user has given a flag that has no effect in this run.  Flags
// for worker processes have no effect if all objects run in this process (`has_processes` is
// false). Flags for DDS have no effect if the run does not use DDS (`has_dds` is false).
void RefuseIdleFlags(const PlacementFlags& flags, bool has_processes, bool has_dds);

// Values of the flags --ros2 and --ros2-namespace.
struct Ros2Flags {
  bool is_on = false;
  std::string space = "aibo";  // first part of the names of all ROS 2 topics
};
void AddRos2Flags(CLI::App* command, Ros2Flags* flags);

// Starts the worker processes that `flags` ask for.  Returns null when all objects run in this
// process.  The workers read the Memory Stick `stick`, and a worker ends when a handler uses more
// than `handler_limit_us` of processor time.  `interrupts` returns how often the user has pressed
// Ctrl-C.  Throws CLI::ValidationError for wrong flags.
std::unique_ptr<WorkerGroup> MakeWorkerGroup(const PlacementFlags& flags, const RunStick& stick,
                                             int64_t handler_limit_us,
                                             std::function<int()> interrupts);

// Makes the connection to DDS for a run without workers, which still needs DDS to send data to
// openr top (--monitor) or to ROS 2 (--ros2).
std::unique_ptr<Bus> MakeBus(const PlacementFlags& flags);

}  // namespace openr_host
