#include "openr/pacing.h"

#include <time.h>

#include "runtime/core/current.h"

namespace openr_host {
namespace {

constexpr int64_t kLateMaxNs = 100'000'000;

}  // namespace

int64_t WallClockNs() {
  const ApiScope scope;  // objects have another clock; this call is not theirs
  timespec now{};
  clock_gettime(CLOCK_MONOTONIC, &now);
  return int64_t{now.tv_sec} * 1'000'000'000 + now.tv_nsec;
}

void Pacer::WaitFor(int64_t time_us) {
  if (rate_ <= 0) return;
  const int64_t now_ns = WallClockNs();
  if (!started_) {
    started_ = true;
    start_wall_ns_ = now_ns;
    start_virtual_us_ = time_us;
    return;
  }
  const double ahead_us = static_cast<double>(time_us - start_virtual_us_);
  const int64_t due_ns = start_wall_ns_ + static_cast<int64_t>(1000 * ahead_us / rate_);
  if (now_ns - due_ns > kLateMaxNs) {
    start_wall_ns_ = now_ns;
    start_virtual_us_ = time_us;
    return;
  }
  const timespec due{due_ns / 1'000'000'000, due_ns % 1'000'000'000};
  clock_nanosleep(CLOCK_MONOTONIC, TIMER_ABSTIME, &due, nullptr);
}

}  // namespace openr_host
