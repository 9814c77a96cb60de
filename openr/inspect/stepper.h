// The command openr replay --step: steps through a replay forward and back.
#pragma once

#include "openr/inspect/replayer.h"

namespace openr_host {

// Reads commands from standard input and answers on standard output, until "quit" or the end of the
// input.  Returns false if the replay has met a difference.  Throws the exceptions of Replayer.
//
// Going back is exact, because processes are kept as snapshots.  After every 1000 messages the
// process forks: the copy continues the session, and the original waits as a snapshot.  To go back
// to a message, the running copy ends, and so do the waiting processes whose snapshots are later
// than that message.  The latest snapshot that is left makes a new copy, which runs forward to the
// message.  REQUIRES: the process has one thread, because fork() copies only the calling thread.
bool StepThrough(const ReplayOptions& options);

}  // namespace openr_host
