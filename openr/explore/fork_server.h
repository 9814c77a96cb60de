// Makes runs of the objects of a stick, each in a copy of the process (fork).
//
// Assembling a run takes longer than the run itself.  A copy of the process has the assembled run
// at once.  Every run begins in the same state, because an earlier run has changed only its own
// copy.
#pragma once

#include <cstdint>
#include <nlohmann/json_fwd.hpp>
#include <string>

#include "openr/explore/run_plan.h"

namespace openr_host {

struct ForkLimits {
  int64_t handler_us = 2'000'000;  // largest processor time that a handler may use
  int wall_s = 120;  // longest real time that a run may take; only a run that hangs needs so long
};

// Field of the JSON answer about a run that was killed after ForkLimits::wall_s.  Such an answer
// has no hashes.
inline constexpr char kNotEnded[] = "not_ended";

class ForkServer {
 public:
  // Makes a server for the run `prepared`.  REQUIRES: System::Boot() has not been called for this
  // run, because every copy calls it; the process has one thread, because fork() copies no other
  // thread.
  ForkServer(PreparedRun prepared, RunOptions options, ForkLimits limits);
  ~ForkServer();
  ForkServer(const ForkServer&) = delete;
  ForkServer& operator=(const ForkServer&) = delete;

  // Runs `plan` in a copy of the process and returns the answer of RunPlan().  If the copy crashes,
  // the answer says that the property no-crash is broken.  A handler that uses more time than
  // handler_us of the ForkLimits, or a copy that must be killed after wall_s seconds, breaks the
  // property handlers-return; the answer about a killed copy also has the field kNotEnded.  If the
  // plan does not fit the run, for example names an object that the run does not have, the answer
  // is {"problem": text}.  Throws std::runtime_error if the system gives no copy of the process, or
  // if the answer of the copy cannot be read.
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
  DeviationLog* log_;  // memory shared with the copies, so the log outlives a crash of a copy
};

}  // namespace openr_host
