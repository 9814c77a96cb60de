// KnownRun: a run whose inputs from outside are known before it begins.  It is a recording, or a
// failing run of an exploration.
//
// People can watch a known run like any other run, but cannot change what happens in it.
#pragma once

#include <cstdint>
#include <string>

namespace openr_host {

class Simulation;

class KnownRun {
 public:
  virtual ~KnownRun() = default;

  virtual Simulation& simulation() = 0;

  // Gives the run the inputs that are due now.  Then delivers the next message if it is due by
  // `time_us`.  Otherwise sets the clock to `time_us`, or to the time of the next input if this
  // input is due earlier.  Does nothing when the run is over.
  virtual void RunOne(int64_t time_us) = 0;

  // Returns the virtual time at which the run is over.
  virtual int64_t length_us() const = 0;

  // Returns the reason why the run is over, as a text for users.  Returns "" while the run goes on.
  virtual std::string EndReason() const = 0;

  // Runs to the virtual time `time_us` or to the end of the run.  Delivers all messages that are
  // due at `time_us`, too.
  void RunUntil(int64_t time_us);

  // Runs as RunUntil() does, and shows the progress on the terminal `descriptor`; -1: shows none.
  void RunWithProgress(int64_t time_us, int descriptor);
};

}  // namespace openr_host
