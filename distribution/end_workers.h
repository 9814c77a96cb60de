// EndWorkers(): ends the workers of a run that is over.
#pragma once

#include <cstdint>
#include <functional>
#include <vector>

namespace openr_host {

// The steps by which EndWorkers() ends one worker.
struct EndingWorker {
  // Tells the worker that the run is over, and does not wait.  Returns false if there is no worker
  // that can be told.
  std::function<bool()> tell;
  // Returns whether the process of the worker has ended.  If the process has ended, EndWorkers()
  // does not wait until this worker has received what tell() has sent.
  std::function<bool()> has_ended;
  // Waits until the worker has received what tell() has sent, at most `limit_ms`.  Returns whether
  // the worker has received it.
  std::function<bool(int64_t limit_ms)> await_receipt;
  // Waits until the process of the worker has ended, at most `limit_ms`.  Returns whether the
  // process has ended.  May kill a process that has never joined the run, because nothing of the
  // run is lost with it.
  std::function<bool(int64_t limit_ms)> await_exit;
  // Kills the process of the worker.  Called when await_exit() has not seen the end of the process.
  std::function<void()> kill;
};

struct EndLimits {
  // Time limit until all workers have confirmed that they know of the end of the run.
  int64_t receipt_ms;
  // Time limit, counted from then on, until the processes of all workers have ended.
  int64_t exit_ms;
  // Replaces `receipt_ms` and `exit_ms` as soon as the user does not want to wait any more.  If a
  // wait is under way at that time, it lasts at most `interrupted_ms` longer.
  int64_t interrupted_ms;
};

// Longest time that EndWorkers() waits before it checks again whether the user still wants to wait.
constexpr int64_t kEndSliceMs = 100;

// Tells all `workers` that the run is over.  Then waits until they have received this message, and
// then until their processes have ended.  Kills a process that has not ended in time.  If a worker
// has not received the message, it does not know that it has to end, so its process is killed at
// once.  Does not wait for a worker whose process has ended already.
//
// The time limits are for all workers together, because several workers may be suspended (SIGSTOP)
// or may run handlers that never end.  `is_interrupted` returns whether the user does not want to
// wait.  Its result may become true during a wait, so a long wait is made in slices of kEndSliceMs.
// `now_ms` is the clock.
void EndWorkers(const std::vector<EndingWorker>& workers, const EndLimits& limits,
                const std::function<bool()>& is_interrupted,
                const std::function<int64_t()>& now_ms);

}  // namespace openr_host
