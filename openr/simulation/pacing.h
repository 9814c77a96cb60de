// Keeps virtual time in step with the wall clock.  The only place where the wall clock decides
// anything, and it only decides when to go on.
#pragma once

#include <cstdint>

namespace openr_host {

class Pacer {
 public:
  // Virtual seconds per second; 0: as fast as possible.
  explicit Pacer(double rate) : rate_(rate) {}

  // Sleeps until virtual time `time_us` is due.  Returns early on a signal.  A run that is more
  // than 0.1 s late does not rush to catch up: from there on it is in step again.
  void WaitFor(int64_t time_us);

  // The virtual time that is due at this moment, in a run that has come to `reached_us`; the same
  // holds for one that is late.  Needs a rate.
  int64_t TimeNow(int64_t reached_us);

  // From now on as fast as possible.
  void LetGo() { rate_ = 0; }

 private:
  int64_t DueNs(int64_t time_us) const;
  bool StartsAt(int64_t time_us, int64_t now_ns);

  double rate_;
  bool started_ = false;
  int64_t start_wall_ns_ = 0;
  int64_t start_virtual_us_ = 0;
};

}  // namespace openr_host
