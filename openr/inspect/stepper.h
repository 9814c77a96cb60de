// The command openr replay --step: steps through a replay forward and back.
#pragma once

#include "openr/inspect/replayer.h"

namespace openr_host {

// Reads commands from descriptor 0 and answers on standard output until "quit" or the end of the
// input.  Returns false if the replay has met a difference.  Throws the exceptions of Replayer.
//
// Going back is exact.  At every snapshot the process forks; the copy continues and the original
// waits.  To go back, copies end until the nearest original before the wanted message is reached.
// It makes a new copy and runs that forward.  REQUIRES: the process has one thread.
bool StepThrough(const ReplayOptions& options);

}  // namespace openr_host
