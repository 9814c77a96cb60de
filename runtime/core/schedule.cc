#include "runtime/core/schedule.h"

namespace openr_host {

int64_t Schedule::ExtraDelayUs(const Message&, int64_t, int64_t) { return 0; }

bool Schedule::Refuses(const Message&) { return false; }

size_t SeedSchedule::Choose(Question, const std::vector<ObjectId>& candidates) {
  return static_cast<size_t>(rng_.NextBelow(candidates.size()));
}

}  // namespace openr_host
