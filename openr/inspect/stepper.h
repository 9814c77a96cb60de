// The command openr replay --step: steps through a replay forward and back.
#pragma once

#include "openr/inspect/replayer.h"

namespace openr_host {

// Reads commands from standard input and answers on standard output, until "quit" or the end of the
// input.  Returns false if the replay has met a difference.  Throws the exceptions of Replayer.
//
// Going back is exact, because processes are kept as snapshots.  At every snapshot the process
// forks: the copy continues, and the original waits.  To go back, copies end until the last
// original before the wanted message runs again.  That original makes a new copy, which runs
// forward to the wanted message.  REQUIRES: the process has one thread.
bool StepThrough(const ReplayOptions& options);

}  // namespace openr_host
