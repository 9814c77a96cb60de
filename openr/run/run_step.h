// Makes the steps of a paused run: over a frame, or to the next message.
#pragma once

#include <cstdint>
#include <functional>

#include "openr/live/run_clock.h"

namespace openr_host {

class Simulation;

// Makes the step `step` of the paused run of `simulation`.  `run_one` is System::RunOne(), or a
// function that does the same.  `frame_end_us` is the end of the present frame.  A step to a
// message ends after a second of virtual time if no message comes, and earlier if the run ends.
void MakeStep(Simulation* simulation, RunClock::Step step, int64_t frame_end_us,
              const std::function<void(int64_t time_us)>& run_one);

}  // namespace openr_host
