// The steps of a paused run.
#pragma once

#include <cstdint>
#include <functional>

#include "openr/live/run_clock.h"

namespace openr_host {

class Simulation;

// Makes one step of the run of `simulation`.  `run_one` is System::RunOne(), or a function that
// does the same.  `frame_end_us` is the end of the frame that runs now.  A step to a message that
// does not come ends after a second of virtual time, or when the run does not go on any more.
void MakeStep(Simulation* simulation, RunClock::Step step, int64_t frame_end_us,
              const std::function<void(int64_t time_us)>& run_one);

}  // namespace openr_host
