// The flags of openr run.
#pragma once

#include <CLI/CLI.hpp>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "openr/commands/distribution_flags.h"
#include "openr/data/data_log.h"
#include "openr/ending/end_guards.h"
#include "openr/panel/listen.h"
#include "openr/run/runner.h"
#include "openr/simulation/run_stick.h"
#include "openr/simulation/simulation.h"

namespace openr_host {

struct RunFlags {
  SimulationOptions simulation;
  PlacementFlags placement;
  Ros2Flags ros2;
  std::optional<int64_t> for_us;
  const CLI::Option* for_flag = nullptr;
  bool until_idle = false;
  std::string rate = "1";
  std::string report_file;
  std::string record_file;
  // Options of --log-data; `data_log.file` is "" if the user wants no log of data.
  DataLogOptions data_log;
  std::string timeline_file;
  bool no_payloads = false;
  bool json = false;
  bool panel = false;     // value of the flag --panel
  bool no_panel = false;  // value of the flag --no-panel
  uint16_t panel_port = 8210;
  ListenOptions listen;
  std::string log = "info";
  std::string console_file;
  std::string stdin_file;
  std::string events_file;
  // Value of --jobs: how many robots run at the same time, each in a process of its own; 0: the
  // flag was not given, so all robots are in one System of this process.
  int jobs = 0;
  std::string gdb;  // value of --gdb, the name of an object; "": no debugger
  int64_t handler_limit_us = 10'000'000;
  std::vector<std::string> snapshots;
  std::vector<std::string> snapshot_files;
};

// Adds the flags of openr run to `command`.  Their values are stored in `flags` when the command
// line is read.
void DescribeRunFlags(CLI::App* command, RunFlags* flags);

// Adds the flags --log-data, --log-images and --timeline, which openr run and openr replay have.
void AddDataLogFlags(CLI::App* command, DataLogOptions* options, std::string* timeline);

// Returns whether the run has a panel.  The flags --panel, --no-panel and --listen decide this.
// Without these flags, the run has a panel if the panel is installed and a person seems to look at
// the run: standard output is a terminal, and the flag --json is not given.
bool WantsPanel(const RunFlags& flags);

// Returns the plan of the run that the flags describe.  Throws CLI::ValidationError if two flags
// contradict each other, or if a value cannot be used.
RunPlan PlanOf(const RunFlags& flags);

// Returns the guards of the run that the flags describe; `stick` is the stick of the run.
EndGuardOptions GuardsOf(const RunFlags& flags, const RunStick& stick);

}  // namespace openr_host
