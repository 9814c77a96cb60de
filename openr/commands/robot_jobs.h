// openr run --robots N --jobs K: runs N robots, each on its own, K of them at a time.
#pragma once

#include <CLI/CLI.hpp>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <string_view>

#include "cli/console.h"
#include "cli/process_copy.h"
#include "openr/commands/run_flags.h"
#include "openr/ending/end_guards.h"
#include "openr/run/interrupt.h"
#include "openr/simulation/run_stick.h"
#include "openr/simulation/simulation.h"

namespace openr_host {

// Throws CLI::ValidationError, with the reason, if the user has given a flag that cannot be used
// together with --jobs.
void RefuseFlagsBesideJobs(const RunFlags& flags);

// Runs each robot in a copy of this process (fork), with a System for this robot only.  The images
// are loaded once, before the copies are made, so all robots begin in the same state.  Therefore
// the hashes of a robot depend only on its number, and not on the number of robots or jobs.  The
// memory does not grow with the number of robots, except for their reports.
class RobotJobs {
 public:
  // Prepares the runs that the flags describe.  REQUIRES: flags.jobs > 0; RefuseFlagsBesideJobs()
  // has accepted the flags.
  explicit RobotJobs(const RunFlags& flags);

  // Runs the robots, prints a summary on standard error, and returns the report.  At Ctrl-C,
  // presses the pause button of the robots that run, and starts no other robot.
  nlohmann::ordered_json Run();

 private:
  SimulationOptions Options();
  ProcessCopy Start(int robot);
  void RunInCopy(int robot, int answer);
  void Print(std::string_view text);
  void StoreReport(int robot, const std::string& said, int status);
  void RunAll();
  nlohmann::ordered_json ReportOfNoBoot();
  nlohmann::ordered_json Merge(double wall_time_s);

  const RunFlags flags_;
  const RunPlan plan_;
  const RunStick stick_;
  Console console_;
  InterruptCounter interrupts_;
  // Number of the robot that this copy of the process runs; -1: the original process.
  int robot_ = -1;
  // Beginning of a line that the objects of this robot have printed; its end has not been printed
  // yet.
  std::string line_;
  std::optional<EndGuards> guards_;  // guards the loading of the images
  Simulation simulation_;
  // The report of each robot, by the number of the robot; null: the robot has not run.
  std::vector<nlohmann::ordered_json> reports_;
};

}  // namespace openr_host
