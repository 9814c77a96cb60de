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
  // Waits until the worker has received what tell() has sent, at most `limit_ms`.  Returns whether
  // the worker has received it.
  std::function<bool(int64_t limit_ms)> await_receipt;
  // Waits until the process of the worker has ended, or kills this process.  `is_silent` is true if
  // await_receipt() has returned false: the process does not know that the run is over.
  std::function<void(bool is_silent)> await_exit;
};

// Tells all `workers` that the run is over.  Then waits until they have received this, for all of
// them together at most `limit_ms`.  Then waits until their processes have ended.
//
// Several worker processes may be suspended (SIGSTOP), so that they receive nothing until they go
// on.  So all workers are told before the first wait, and each wait has only the time that the
// waits before it have left.  `now_ms` is the clock.
void EndWorkers(const std::vector<EndingWorker>& workers, int64_t limit_ms,
                const std::function<int64_t()>& now_ms);

}  // namespace openr_host
