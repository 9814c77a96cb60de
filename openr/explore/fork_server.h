// Makes runs of one graph, each in a copy of the process (fork).
//
// Assembling a run costs more than the run itself.  A copy of the process is ready at once, and
// every run begins in the same state, whatever an earlier run has done.
#pragma once

#include <cstdint>
#include <nlohmann/json_fwd.hpp>
#include <string>

#include "openr/explore/run_plan.h"

namespace openr_host {

struct ForkLimits {
  int64_t handler_us = 2'000'000;  // limit of processor time of one handler
  int wall_s = 120;                // limit of real time of a run; only a run that hangs reaches it
};

class ForkServer {
 public:
  // REQUIRES: the prepared run has not booted, and the process has one thread.
  ForkServer(PreparedRun prepared, RunOptions options, ForkLimits limits);
  ~ForkServer();
  ForkServer(const ForkServer&) = delete;
  ForkServer& operator=(const ForkServer&) = delete;

  // Runs `plan` in a copy of the process and returns the answer of RunPlan().  If the copy crashes,
  // the answer says that the property no-crash is broken; if the copy must be killed, that
  // handlers-return is broken.  Both name the handler.  A plan that does not fit gives {"problem":
  // text}.
  nlohmann::ordered_json Run(const nlohmann::ordered_json& plan);

 private:
  nlohmann::ordered_json AnswerOfEndedCopy(const nlohmann::ordered_json& plan,
                                           const std::string& said, int status);
  nlohmann::ordered_json Broken(const nlohmann::ordered_json& plan, const char* property,
                                const std::string& text);
  [[noreturn]] void RunInCopy(const nlohmann::ordered_json& plan, int answer);

  PreparedRun prepared_;
  const RunOptions options_;
  const ForkLimits limits_;
  DeviationLog* log_;  // shared with the copies, so that a crash does not lose it
};

}  // namespace openr_host
