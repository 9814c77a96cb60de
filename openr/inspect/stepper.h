// openr replay --step: a prompt in front of a replay that goes forward and back.
#pragma once

#include "openr/inspect/replayer.h"

namespace openr_host {

// Reads commands from descriptor 0 and answers on standard output until "quit" or the end of
// the input.  False when the replay has met a difference by then.  Throws what Replayer throws.
//
// Going back is exact: at every snapshot the process forks; the copy goes on, the original
// waits.  To go back, copies end until the nearest original before the wanted message is
// reached, which makes a new copy and runs it forward.  REQUIRES: no threads.
bool StepThrough(const ReplayOptions& options);

}  // namespace openr_host
