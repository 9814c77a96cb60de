// The state of a session of openr replay --step, in memory that all processes of the session share
// (stepper.h describes these processes).
#pragma once

#include <cstdint>

#include "cli/prompt.h"
#include "openr/inspect/snapshot_list.h"

namespace openr_host {

// Data that the processes of openr replay --step share.  When the user goes back, the present
// process ends.  Before this, it writes here what must be done next by the process of an earlier
// snapshot, which has waited until then.
struct SharedSession {
  bool went_back;    // true: the last process has ended because the user goes back
  uint64_t target;   // number of messages after which going back ends
  int64_t until_us;  // virtual time up to which the session runs after going back; 0: none
  // True while a process of openr replay --step carries out the user's commands.  A process that
  // ends as it should sets `is_running` to false.  If `is_running` is still true when the process
  // has ended, the run has crashed.
  bool is_running;
  bool ends;  // true: openr replay --step must end
  bool differs;
  bool is_text_lost;  // true: a process could not write some text to standard output
  int lost_errno;     // the errno of the first failed write; 0: the reason is not known
  SnapshotList snapshots;
  char breaks[16 << 10];  // the breakpoints as text (Breakpoints::Save())
  PromptHistory history;

  // Notes that text for standard output was lost.  openr replay --step then ends with the exit code
  // for lost answers.  `error` is an errno, or 0 if the reason is not known.
  void NoteLostText(int error);

  // Writes out the text in the buffers of the streams, which fork() would double and _exit() would
  // drop.  Returns false if some text for standard output was lost, now or earlier.
  bool FlushText();
};

}  // namespace openr_host
