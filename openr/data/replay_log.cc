#include "openr/data/replay_log.h"

#include <algorithm>

#include "cli/progress_line.h"
#include "openr/ending/ending.h"
#include "openr/inspect/replayer.h"
#include "openr/timeline/timeline.h"
#include "runtime/core/system.h"

namespace openr_host {

std::string LogReplay(Replayer* replayer, const DataLogOptions& options,
                      const std::string& timeline_file, int64_t until_us, int descriptor) {
  System& system = replayer->system();
  std::unique_ptr<DataLog> log;
  std::unique_ptr<Timeline> timeline;
  if (!options.file.empty()) log = MakeDataLog(options, &replayer->simulation());
  if (!timeline_file.empty()) timeline = std::make_unique<Timeline>(timeline_file, &system);
  const auto finish = [&] {
    const std::string of_log = log == nullptr ? "" : log->Finish();
    const std::string of_timeline = timeline == nullptr ? "" : timeline->Finish();
    return of_log.empty() ? of_timeline : of_log;
  };
  const EndingAction ending_action([&finish](Ending*) { finish(); });
  RunProgressLine progress(descriptor, system.now_us(), std::min(until_us, replayer->length_us()));
  while (replayer->EndReason().empty() && system.now_us() < until_us) {
    const int64_t before_us = system.now_us();
    const int64_t frame_end_us = (before_us / kFrameUs + 1) * kFrameUs;
    replayer->RunUntil(std::min(frame_end_us, until_us));
    if (timeline != nullptr) timeline->Rest();
    if (log != nullptr && system.now_us() == frame_end_us) log->Sample();
    progress.Show(system.now_us());
    // Ends the loop if the virtual time has not changed, because then all robots are off, and the
    // time would never reach `until_us`.
    if (system.now_us() == before_us) break;
  }
  return finish();
}

}  // namespace openr_host
