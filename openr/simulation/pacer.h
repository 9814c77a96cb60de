// Pacer, which keeps virtual time in step with the clock of this computer.  It decides only when a
// run goes on, never what happens in it.
#pragma once

#include <cstdint>

namespace openr_host {

class Pacer {
 public:
  // The smallest and the largest rate that a user can give, by the option --rate or in a running
  // run.  A user can also give the rate 0, "as fast as possible".
  static constexpr double kRateMin = 0.001, kRateMax = 1000;

  // Makes a pacer.  `rate` is virtual seconds per real second; 0: as fast as possible.
  explicit Pacer(double rate) : rate_(rate) {}

  double rate() const { return rate_; }
  // Sets the rate that the run has from the present instant on.
  void set_rate(double rate);
  // Makes the run go on from the present instant, without catching up.  Called after a pause.
  void Restart() { started_ = false; }

  // Sleeps until the clock of this computer lets the run go on to the virtual time `time_us`, or
  // until a signal comes.  If the run is more than 0.1 s late, it goes on at `rate` from the
  // present instant.  It does not catch up, because the robot would then move too fast for a while.
  void WaitFor(int64_t time_us);

  // Returns the virtual time to which the run may go on now, by the clock of this computer.
  // `reached_us` is the virtual time that the run has reached.  If the run is more than 0.1 s late,
  // returns `reached_us`: the run then goes on at `rate` from the present instant and does not
  // catch up.  REQUIRES: rate > 0.
  int64_t TimeNow(int64_t reached_us);

 private:
  int64_t DueNs(int64_t time_us) const;
  bool StartsAt(int64_t time_us, int64_t now_ns);

  double rate_;
  bool started_ = false;
  int64_t start_wall_ns_ = 0;
  int64_t start_virtual_us_ = 0;
};

}  // namespace openr_host
