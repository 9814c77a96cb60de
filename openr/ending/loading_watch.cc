#include "openr/ending/loading_watch.h"

#include <cstdint>
#include <string>
#include <vector>

namespace openr_host {
namespace {

// The processor time after which the loading of an image is ended, if the command has no Watchdog.
constexpr int64_t kLoadingUsMax = 10'000'000;

}  // namespace

LoadingWatch::LoadingWatch() {
  if (!EndingAnswer::exists()) ending_answer_.emplace(-1);
  if (!CrashLog::exists()) crash_log_.emplace(std::vector<std::string>());
  if (!Watchdog::exists()) watchdog_.emplace(kLoadingUsMax, "");
}

}  // namespace openr_host
