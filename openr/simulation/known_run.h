// KnownRun: a run of which everything that comes from outside is known before: a recording, or a
// failing run of an exploration.
//
// Such a run can be watched like one that is under way, but nobody can change what happens in it.
#pragma once

#include <cstdint>
#include <string>

namespace openr_host {

class Simulation;

class KnownRun {
 public:
  virtual ~KnownRun() = default;

  virtual Simulation& simulation() = 0;

  // Gives the run the input that is due now.  Then delivers the next message if it is due by
  // `time_us`, or else sets the clock to `time_us`, or to an earlier input.  Does nothing when the
  // run is over.
  virtual void RunOne(int64_t time_us) = 0;

  // Returns the virtual time at which the run is over.
  virtual int64_t length_us() const = 0;

  // Returns why the run is over, for users; "" while it goes on.
  virtual std::string WhyOver() const = 0;

  // Runs to the virtual time `time_us`, behind all messages that are due then, or to the end.
  void RunUntil(int64_t time_us);
};

}  // namespace openr_host
