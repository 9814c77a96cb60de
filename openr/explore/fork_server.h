// Runs of one graph, each in a copy of the process (fork).
//
// Putting a run together costs more than a run; a copy of the process is ready at once, and
// whatever a run does to it, the next one begins the same.
#pragma once

#include <cstdint>
#include <nlohmann/json_fwd.hpp>
#include <string>

#include "openr/explore/run_plan.h"

namespace openr_host {

struct ForkLimits {
  int64_t handler_us = 2'000'000;  // processor time of one handler
  int wall_s = 120;                // of a whole run; only a run that hangs takes so long
};

class ForkServer {
 public:
  // REQUIRES: the prepared run has not booted, and the process has one thread.
  ForkServer(PreparedRun prepared, RunOptions options, ForkLimits limits);
  ~ForkServer();
  ForkServer(const ForkServer&) = delete;
  ForkServer& operator=(const ForkServer&) = delete;

  // The answer of RunPlan() in a copy.  A copy that crashes answers with the property no-crash
  // broken, one that has to be ended with handlers-return; both name the handler.  A plan that
  // does not fit gives {"problem": text}.
  nlohmann::ordered_json Run(const nlohmann::ordered_json& plan);

 private:
  nlohmann::ordered_json AnswerOfTheDead(const nlohmann::ordered_json& plan,
                                         const std::string& said, int status);
  nlohmann::ordered_json Broken(const nlohmann::ordered_json& plan, const char* property,
                                const std::string& text);
  [[noreturn]] void RunInCopy(const nlohmann::ordered_json& plan, int answer);

  PreparedRun prepared_;
  const RunOptions options_;
  const ForkLimits limits_;
  DeviationLog* log_;  // shared with the copies, so that a crash does not take it along
};

}  // namespace openr_host
