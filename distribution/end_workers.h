// EndWorkers(): ends the workers of a run that is over.
#pragma once

#include <cstdint>
#include <functional>
#include <vector>

namespace openr_host {

// The steps that EndWorkers() does with one worker.
struct EndingWorker {
  // Tells the worker that the run is over, and does not wait.  Returns false if no worker is there
  // that could be told.
  std::function<bool()> tell;
  // Returns whether the process of the worker has ended, so that the worker will receive nothing.
  std::function<bool()> has_ended;
  // Waits until the worker has received what tell() has sent, at most `limit_ms`.  Returns whether
  // the worker has received it.
  std::function<bool(int64_t limit_ms)> await_receipt;
  // Waits until the process of the worker has ended, at most `limit_ms`.  Returns whether the
  // process has ended.  May kill a process that has never joined the run, because nothing of the
  // run is lost with it.
  std::function<bool(int64_t limit_ms)> await_exit;
  // Kills the process of the worker, which has not ended.
  std::function<void()> kill;
};

struct EndLimits {
  int64_t receipt_ms;  // time for all workers together to receive that the run is over
  int64_t exit_ms;     // time for all workers together to end after that
  // Replaces both times above as soon as the user does not want to wait; a wait that has begun
  // lasts at most this time from then on.
  int64_t interrupted_ms;
};

// The longest wait of EndWorkers() during which it does not look whether the user wants to wait on.
constexpr int64_t kEndSliceMs = 100;

// Tells all `workers` that the run is over.  Then waits until they have received this, and then
// until their processes have ended.  A worker that has not received it does not know that it has to
// end, so its process is killed at once.  A worker whose process has ended, because it was killed
// for example, is not waited for.
//
// Several worker processes may be suspended (SIGSTOP), so that they receive nothing until they go
// on, or may run handlers that never end.  So all workers are told before the first wait, and each
// wait has only the time that the waits before it have left.  `is_interrupted` returns whether the
// user does not want to wait; its result may become true during a wait, so a long wait is made in
// slices of kEndSliceMs.  `now_ms` is the clock.
void EndWorkers(const std::vector<EndingWorker>& workers, const EndLimits& limits,
                const std::function<bool()>& is_interrupted,
                const std::function<int64_t()>& now_ms);

}  // namespace openr_host
