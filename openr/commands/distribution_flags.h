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

// --dds-domain, --dds-address, --dds-peer, --dds-config.
void AddBusFlags(CLI::App* command, BusOptions* bus);

// For --run-name and --process; `what`: "run", "process".
CLI::Validator IsNameOf(const std::string& what);

struct PlacementFlags {
  std::vector<std::string> places;  // OBJECT=PROCESS
  std::string file;
  std::vector<std::string> isolated;  // objects
  std::string wrapper;                // command line of a debugger
  bool is_free = false;
  bool is_monitored = false;  // speaks of itself though all is in one process
  BusOptions bus;
  int64_t wait_us = 60'000'000;
  int restarts = 0;
  std::vector<const CLI::Option*> of_processes;  // mean nothing in a run of one process
  std::vector<const CLI::Option*> of_dds;        // nor in one that does not speak DDS
};

// --place, --placement, --isolate, --wrap, --monitor, --run-name, --join-wait and those of
// AddBusFlags().
void AddPlacementFlags(CLI::App* command, PlacementFlags* flags);

// Throws CLI::ValidationError when one of them was given that means nothing in a run like this.
void RefuseIdleFlags(const PlacementFlags& flags, bool has_processes, bool has_dds);

// --ros2 and --ros2-namespace.
struct Ros2Flags {
  bool is_on = false;
  std::string space = "aibo";  // namespace
};
void AddRos2Flags(CLI::App* command, Ros2Flags* flags);

// Makes the processes that the flags of placement ask for; null when all is in one process.  Throws
// CLI::ValidationError.
std::unique_ptr<WorkerGroup> MakeWorkerGroup(const PlacementFlags& flags, const RunStick& stick,
                                             int64_t handler_limit_us,
                                             std::function<int()> interrupts);

// Of a run that is all in this process and speaks DDS all the same.
std::unique_ptr<Bus> MakeBus(const PlacementFlags& flags);

}  // namespace openr_host
