// The part of openr explore that repeats a failing run: to check a schedule file, or to write the
// recording of the run.
#pragma once

#include <cstdint>
#include <nlohmann/json_fwd.hpp>

#include "openr/commands/explore_flags.h"

namespace openr_host {

// Repeats the failing run of the schedule file (openr explore -o) that --replay names, and says
// whether the run fails in the same way.  Returns the exit code.
int ReplayFailure(ExploreFlags flags);

// Runs the failing run once more and writes its recording.  `answer` is the answer that
// ReplayDeviations() has returned for this run; it says how the run ended.  Must be called last,
// because this process ends if an object crashes in the run.  The recording then ends at the crash.
// Returns false after printing an error.
bool RecordFailure(const ExploreFlags& flags, const ExploredStick& stick, uint64_t seed,
                   const nlohmann::ordered_json& deviations, const nlohmann::ordered_json& answer);

}  // namespace openr_host
