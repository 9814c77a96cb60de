// The command openr replay --step: lets the user step through a replay, forward and back.
#pragma once

#include "openr/inspect/replayer.h"

namespace openr_host {

// Reads the user's commands from standard input and answers on standard output, until "quit" or the
// end of the input.  Returns false if the replay has met a difference from the recording.  Throws
// the exceptions of Replayer.  Returns early if an answer cannot be written, and notes the loss
// (NoteLostAnswer()), so that the program ends with the exit code for lost answers.
//
// Going back is exact, because processes serve as snapshots.  After every 1000 messages the process
// forks: the child process, called the copy, goes on with the user's commands, and its parent
// waits.  When the user goes back to a message, the running copy ends, and so does each waiting
// process whose snapshot is later than that message.  The latest of the remaining processes makes a
// new copy, which runs forward to the message.  The older the snapshots are, the fewer of them are
// kept (snapshot_list.h).  REQUIRES: the process has no child processes, and has only one thread,
// because fork() copies only the calling thread.
bool StepThrough(const ReplayOptions& options);

}  // namespace openr_host
