// Runs a prepared run from Boot() to its end and makes its answer.
#pragma once

#include <cstdint>
#include <functional>
#include <nlohmann/json_fwd.hpp>

#include "openr/explore/explore_schedule.h"
#include "openr/explore/property.h"

namespace openr_host {

// Options that are the same for all runs of an exploration.
struct RunOptions {
  int64_t for_us = 20'000'000;  // virtual time
  Vary vary;
  PropertyChoice properties;
};

// Makes one run.  Its plan and its answer are JSON, because they are sent between processes.
//
// Plan: "seed"; then the schedule is drawn from the seed, or
//   "script"  deviations to play again (deviation.h)
//   "exact"   choices of a search (exact_schedule.h)
// and, all optional:
//   "until_us"  instead of RunOptions::for_us     "slice_us"  time run in one go (a frame)
//   "blind"     true: no property is looked at    "deviations" true: also given when all is well
//   "tail"      number of last messages in the answer
//
// Answer: "seed", "time_us", "messages", "state" and "trace" (hashes, 16 hex digits), "warnings",
// "errors" (findings); and
//   "broken"      null, or the first property that did not hold:
//                 {"property", "time_us", "message" (number of the last one), "text"}
//   "deviations"  when broken, or asked for
//   "waits"       when broken: who waits, a text each
//   "tail"        the last messages, a text each
//   "exact"       of a search
// Throws std::runtime_error when the plan does not fit the prepared run.
//
// Uses the prepared run up: it cannot boot again.  `log` hears of deviations as they come.
// `on_death` gets the answer of a run that ends with the process (ending.h): "broken" says why,
// hashes are not in it.
nlohmann::ordered_json RunPlan(
    PreparedRun* prepared, const nlohmann::ordered_json& plan, const RunOptions& options,
    DeviationLog* log = nullptr,
    const std::function<void(const nlohmann::ordered_json& answer)>& on_death = {});

}  // namespace openr_host
