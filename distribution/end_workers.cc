#include "distribution/end_workers.h"

#include <algorithm>
#include <cstddef>

namespace openr_host {

void EndWorkers(const std::vector<EndingWorker>& workers, const EndLimits& limits,
                const std::function<int64_t()>& now_ms) {
  std::vector<bool> is_told;
  for (const EndingWorker& worker : workers) is_told.push_back(worker.tell());
  // Returns what is left until `end_ms`.
  const auto left_until = [&](int64_t end_ms) { return std::max<int64_t>(0, end_ms - now_ms()); };
  const int64_t receipt_end_ms = now_ms() + limits.receipt_ms;
  std::vector<bool> is_silent;
  for (size_t i = 0; i < workers.size(); ++i)
    is_silent.push_back(is_told[i] && !workers[i].await_receipt(left_until(receipt_end_ms)));
  const int64_t exit_end_ms = now_ms() + limits.exit_ms;
  for (size_t i = 0; i < workers.size(); ++i)
    workers[i].await_exit(is_silent[i] ? 0 : left_until(exit_end_ms));
}

}  // namespace openr_host
