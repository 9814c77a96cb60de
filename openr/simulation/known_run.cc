#include "openr/simulation/known_run.h"

#include <algorithm>

#include "cli/progress_line.h"
#include "openr/simulation/simulation.h"
#include "runtime/core/system.h"

namespace openr_host {

void KnownRun::RunUntil(int64_t time_us) {
  System& system = simulation().system();
  for (;;) {
    const int64_t before_us = system.now_us();
    const uint64_t messages = system.message_count();
    RunOne(time_us);
    if (system.now_us() == before_us && system.message_count() == messages) return;
  }
}

void KnownRun::RunWithProgress(int64_t time_us, int descriptor) {
  constexpr int64_t kSliceUs = 200'000;
  const int64_t begin_us = simulation().system().now_us();
  const int64_t end_us = std::min(time_us, length_us());
  RunProgressLine progress(descriptor, begin_us, end_us);
  for (int64_t slice_us = begin_us + kSliceUs; slice_us < end_us && EndReason().empty();
       slice_us += kSliceUs) {
    RunUntil(slice_us);
    progress.Show(slice_us);
  }
  RunUntil(time_us);
}

}  // namespace openr_host
