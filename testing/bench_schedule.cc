#include "testing/bench_schedule.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "runtime/core/system.h"

namespace openr::testing {

using openr_host::Message;
using openr_host::ObjectId;

BenchSchedule::BenchSchedule(openr_host::System* system, uint64_t seed)
    : system_(system),
      seed_schedule_(seed),
      is_canonical_(seed == openr_host::SystemOptions().seed) {}

void BenchSchedule::Delay(MessageSpec spec, int64_t extra_us) {
  std::erase_if(delays_, [&](const auto& delay) { return delay.first.Text() == spec.Text(); });
  if (extra_us > 0) delays_.emplace_back(std::move(spec), extra_us);
}

size_t BenchSchedule::Choose(Question question, const std::vector<ObjectId>& candidates) {
  for (const std::string& name : preferred_) {
    for (size_t i = 0; i < candidates.size(); ++i) {
      if (system_->object(candidates[i])->name == name) return i;
    }
  }
  return is_canonical_ ? 0 : seed_schedule_.Choose(question, candidates);
}

int64_t BenchSchedule::ExtraDelayUs(const Message& message, int64_t now_us, int64_t delay_us) {
  int64_t extra_us = 0;
  if (!delays_.empty()) {
    const SeenMessage seen(*system_, message);
    for (const auto& [spec, us] : delays_) {
      if (spec.Matches(seen)) extra_us += us;
    }
  }
  if (extra_us == 0 && last_due_us_.empty()) return 0;
  const auto pair = std::pair(message.sender, message.target);
  const auto last = last_due_us_.find(pair);
  if (extra_us == 0 && last == last_due_us_.end()) return 0;
  const int64_t due_us = now_us + delay_us + extra_us;
  int64_t& last_us = last_due_us_[pair];
  last_us = std::max(last_us, due_us);
  return last_us - now_us - delay_us;
}

bool BenchSchedule::Refuses(const Message& message) {
  if (std::all_of(refused_.begin(), refused_.end(),
                  [](const RefusedMessage& refused) { return refused.happened(); })) {
    return false;
  }
  const SeenMessage seen(*system_, message);
  for (RefusedMessage& refused : refused_) {
    if (refused.happened() || !refused.spec_.Matches(seen)) continue;
    if (++refused.matches_ < refused.nth_) continue;
    refused.text_ = seen.Text();
    return true;
  }
  return false;
}

void BenchSchedule::Verify(const ReportAt& report) {
  for (RefusedMessage& refused : refused_) {
    if (refused.happened() || std::exchange(refused.is_optional_, true)) continue;
    report(refused.place_, fmt::format("Refuse: {} of {} came: {}; .Optional() allows that",
                                       refused.matches(), refused.nth_, refused.spec_.Text()));
  }
}

}  // namespace openr::testing
