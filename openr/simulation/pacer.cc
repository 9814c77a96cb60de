#include "openr/simulation/pacer.h"

#include <time.h>

#include "runtime/base/assert.h"
#include "runtime/base/wall_clock.h"
#include "runtime/core/current.h"

namespace openr_host {
namespace {

constexpr int64_t kLateMaxNs = 100'000'000;

}  // namespace

int64_t Pacer::DueNs(int64_t time_us) const {
  const double ahead_us = static_cast<double>(time_us - start_virtual_us_);
  return start_wall_ns_ + static_cast<int64_t>(1000 * ahead_us / rate_);
}

// Sets a new start, from which DueNs() and TimeNow() count: the virtual time `time_us` at the real
// time `now_ns`.  Does so only if the pacer has no start, or if the run is more than kLateMaxNs
// late, because a late run must not catch up.  Returns whether a new start was set.
bool Pacer::StartsAt(int64_t time_us, int64_t now_ns) {
  if (started_ && now_ns - DueNs(time_us) <= kLateMaxNs) return false;
  started_ = true;
  start_wall_ns_ = now_ns;
  start_virtual_us_ = time_us;
  return true;
}

void Pacer::set_rate(double rate) {
  rate_ = rate;
  started_ = false;
}

void Pacer::WaitFor(int64_t time_us) {
  if (rate_ <= 0 || StartsAt(time_us, WallClockNs())) return;
  const int64_t due_ns = DueNs(time_us);
  const timespec due{due_ns / 1'000'000'000, due_ns % 1'000'000'000};
  clock_nanosleep(CLOCK_MONOTONIC, TIMER_ABSTIME, &due, nullptr);
}

int64_t Pacer::TimeNow(int64_t reached_us) {
  ASSERT(rate_ > 0);
  const int64_t now_ns = WallClockNs();
  if (StartsAt(reached_us, now_ns)) return reached_us;
  const double since_us = static_cast<double>(now_ns - start_wall_ns_) / 1000;
  return start_virtual_us_ + static_cast<int64_t>(since_us * rate_);
}

}  // namespace openr_host
