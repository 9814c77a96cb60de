// The flags of openr run.
#pragma once

#include <CLI/CLI.hpp>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "openr/commands/distribution_flags.h"
#include "openr/run/runner.h"
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
  bool no_payloads = false;
  bool json = false;
  bool panel = false;     // --panel
  bool no_panel = false;  // --no-panel
  uint16_t panel_port = 8210;
  std::string log = "info";
  std::string console_file;
  std::string stdin_file;
  std::string events_file;
  int jobs = 0;  // --jobs; 0: all robots in one System of this process
  int64_t handler_limit_us = 10'000'000;
  std::vector<std::string> snapshots;
  std::vector<std::string> snapshot_files;
};

// Adds the flags of openr run to `command`.  Their values are stored in `flags` when the command
// line is read.
void DescribeRunFlags(CLI::App* command, RunFlags* flags);

// Returns whether the run has a panel: with --panel, and without --no-panel if a person sees its
// address on a terminal and the panel is built.
bool WantsPanel(const RunFlags& flags);

// Returns what the flags say about the run.  Throws CLI::ValidationError if two flags do not go
// together, or a value cannot be used.
RunPlan PlanOf(const RunFlags& flags);

}  // namespace openr_host
