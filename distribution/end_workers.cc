#include "distribution/end_workers.h"

#include <algorithm>
#include <cstddef>

namespace openr_host {
namespace {

// Deadline: the time until which EndWorkers() waits for all workers together.
class Deadline {
 public:
  // Sets the deadline to `limit_ms` from now on.  When `is_interrupted` returns true for the first
  // time, moves the deadline to at most `interrupted_ms` after that moment.
  Deadline(int64_t limit_ms, int64_t interrupted_ms, const std::function<bool()>& is_interrupted,
           const std::function<int64_t()>& now_ms)
      : end_ms_(now_ms() + limit_ms),
        interrupted_ms_(interrupted_ms),
        is_interrupted_(is_interrupted),
        now_ms_(now_ms) {}

  // Calls the function `wait_slice` once, and then again until the function returns true or no
  // time is left.  Each call gets the time that it may last, at most kEndSliceMs.  Returns whether
  // the function has returned true.
  bool Wait(const std::function<bool(int64_t limit_ms)>& wait_slice) {
    int64_t left_ms = LeftMs();
    do {
      if (wait_slice(std::min(left_ms, kEndSliceMs))) return true;
      left_ms = LeftMs();
    } while (left_ms > 0);
    return false;
  }

 private:
  // Returns the time until the deadline.  First checks whether the user has interrupted the wait;
  // if so, makes the deadline earlier.
  int64_t LeftMs() {
    if (!has_seen_interrupt_ && is_interrupted_()) {
      has_seen_interrupt_ = true;
      end_ms_ = std::min(end_ms_, now_ms_() + interrupted_ms_);
    }
    return std::max<int64_t>(0, end_ms_ - now_ms_());
  }

  int64_t end_ms_;
  const int64_t interrupted_ms_;
  const std::function<bool()>& is_interrupted_;
  const std::function<int64_t()>& now_ms_;
  // Whether the user has interrupted the wait.  If so, end_ms_ is earlier than at the beginning.
  bool has_seen_interrupt_ = false;
};

}  // namespace

void EndWorkers(const std::vector<EndingWorker>& workers, const EndLimits& limits,
                const std::function<bool()>& is_interrupted,
                const std::function<int64_t()>& now_ms) {
  std::vector<bool> is_told;
  for (const EndingWorker& worker : workers) is_told.push_back(worker.tell());
  Deadline receipt_deadline(limits.receipt_ms, limits.interrupted_ms, is_interrupted, now_ms);
  std::vector<bool> is_silent;
  for (size_t i = 0; i < workers.size(); ++i) {
    const auto needs_no_wait = [&worker = workers[i]](int64_t limit_ms) {
      return worker.has_ended() || worker.await_receipt(limit_ms);
    };
    is_silent.push_back(is_told[i] && !receipt_deadline.Wait(needs_no_wait));
  }
  Deadline exit_deadline(limits.exit_ms, limits.interrupted_ms, is_interrupted, now_ms);
  for (size_t i = 0; i < workers.size(); ++i) {
    const bool has_ended =
        is_silent[i] ? workers[i].await_exit(0) : exit_deadline.Wait(workers[i].await_exit);
    if (!has_ended) workers[i].kill();
  }
}

}  // namespace openr_host
