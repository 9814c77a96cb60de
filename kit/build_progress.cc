#include "kit/build_progress.h"

#include <unistd.h>

#include <algorithm>
#include <cstdint>
#include <optional>
#include <string>

#include "cli/progress_line.h"
#include "kit/kit_log.h"

namespace openr_host {

void ShowBuildProgress(MakeOptions* options, const std::function<std::optional<uint64_t>()>& count,
                       const std::function<void()>& work) {
  const std::optional<uint64_t> total = isatty(STDERR_FILENO) != 0 ? count() : 0;
  ProgressLine progress(total == 0 ? -1 : STDERR_FILENO, total, "sources compiled");
  CompileCounter counter;
  if (progress.is_shown()) {
    // Shows at most the total number of sources, because the counter may be larger: a source that
    // fails is compiled several times, and the counter counts each compilation.
    options->while_waiting = [&progress, &counter, total](const std::string& log) {
      const uint64_t done = counter.CountIn(log);
      progress.Show(std::min(done, total.value_or(done)));
    };
  }
  try {
    work();
  } catch (...) {
    options->while_waiting = {};  // the function must not be called later: it uses local variables
    throw;
  }
  options->while_waiting = {};
}

}  // namespace openr_host
