// RunPlan() makes one run of an exploration (many runs of a program, with different orders of
// messages) from the boot of the robot to the end.  It returns the result of the run as JSON.
#pragma once

#include <cstdint>
#include <functional>
#include <nlohmann/json_fwd.hpp>

#include "openr/explore/explore_schedule.h"
#include "openr/explore/property.h"

namespace openr_host {

// Options that are the same for all runs of an exploration.
struct RunOptions {
  int64_t for_us = 20'000'000;  // length of a run in virtual time
  ScheduleChoices vary;
  PropertyChoice properties;
};

// Makes one run.  Its plan and its answer are JSON, because they are sent between processes.
//
// The plan has "seed", from which the choices of the schedule are drawn, unless it has
//   "script"  the deviations to repeat (deviation.h), or
//   "exact"   the choices of a search (exact_schedule.h)
// It may also have
//   "until_us"    end of the run, instead of RunOptions::for_us
//   "slice_us"    time from one check of the properties to the next (default: a frame)
//   "blind"       true: no property is checked
//   "deviations"  true: the answer has the deviations even if no property is broken
//   "tail"        number of last messages in the answer
//
// The answer has "seed", "time_us", "messages", "state" and "trace" (hashes, 16 hex digits),
// "warnings", "errors" (numbers of findings), and
//   "broken"      null, or the first property that did not hold: {"property", "time_us",
//                 "message" (number of the last message before that), "text"}
//   "deviations"  if a property is broken or the plan asks for them
//   "waits"       if a property is broken: a text for each object that waits for something
//   "tail"        the last messages, a text for each
//   "exact"       the result for the search (ExactSchedule::Result())
// Throws std::runtime_error when the plan does not fit the prepared run.
//
// `prepared` can be used only once, because the robot cannot boot again.  Each deviation is also
// written to `log` at once, so that it is known after a crash.  If the process ends during the run
// (ending.h), `on_death` gets the answer; its "broken" says why the process ends, and it has no
// hashes.
nlohmann::ordered_json RunPlan(
    PreparedRun* prepared, const nlohmann::ordered_json& plan, const RunOptions& options,
    DeviationLog* log = nullptr,
    const std::function<void(const nlohmann::ordered_json& answer)>& on_death = {});

}  // namespace openr_host
