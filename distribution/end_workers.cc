#include "distribution/end_workers.h"

#include <algorithm>
#include <cstddef>

namespace openr_host {

void EndWorkers(const std::vector<EndingWorker>& workers, int64_t limit_ms,
                const std::function<int64_t()>& now_ms) {
  std::vector<bool> is_told;
  for (const EndingWorker& worker : workers) is_told.push_back(worker.tell());
  const int64_t end_ms = now_ms() + limit_ms;
  std::vector<bool> is_silent;
  for (size_t i = 0; i < workers.size(); ++i) {
    const int64_t left_ms = std::max<int64_t>(0, end_ms - now_ms());
    is_silent.push_back(is_told[i] && !workers[i].await_receipt(left_ms));
  }
  for (size_t i = 0; i < workers.size(); ++i) workers[i].await_exit(is_silent[i]);
}

}  // namespace openr_host
