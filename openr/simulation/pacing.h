// Keeps virtual time in step with the wall clock.  This is the only place where the wall clock has
// an influence, and it decides only when to go on.
#pragma once

#include <cstdint>

namespace openr_host {

class Pacer {
 public:
  // `rate` is virtual seconds per second; 0: as fast as possible.
  explicit Pacer(double rate) : rate_(rate) {}

  // Sleeps until virtual time `time_us` is due, or until a signal comes.  A run that is more than
  // 0.1 s late does not catch up; it keeps the step from there on.
  void WaitFor(int64_t time_us);

  // Returns the virtual time that is due now, for a run that has reached `reached_us`.  A late run
  // does not catch up here either.  REQUIRES: rate > 0.
  int64_t TimeNow(int64_t reached_us);

 private:
  int64_t DueNs(int64_t time_us) const;
  bool StartsAt(int64_t time_us, int64_t now_ns);

  const double rate_;
  bool started_ = false;
  int64_t start_wall_ns_ = 0;
  int64_t start_virtual_us_ = 0;
};

}  // namespace openr_host
