// InterruptCounter, which counts Ctrl-C, SIGTERM and SIGHUP.  The run reads the count after each
// frame.
#pragma once

namespace openr_host {

// The possible effects of the signal SIGHUP, which comes when the terminal of this process is
// closed.
enum class HangUp {
  kEnds,     // the signal ends the process, which is its default action
  kCounts,   // the signal is counted like Ctrl-C
  kIgnored,  // the signal has no effect, because the run ends by itself
};

// While an InterruptCounter exists, SIGINT and SIGTERM are counted and do not end the process.
// After the second signal, a handler of an object that does not return within 1 s ends the process
// with a report (interrupt_limit.h).  The third signal ends the process at once and without a
// report, in case the run hangs.
class InterruptCounter {
 public:
  explicit InterruptCounter(HangUp hang_up = HangUp::kEnds);
  ~InterruptCounter();
  InterruptCounter(const InterruptCounter&) = delete;
  InterruptCounter& operator=(const InterruptCounter&) = delete;

  int count() const;

  // Sets the count of Ctrl-C and similar signals to 0.  Called in a fork of the process, after the
  // fork has changed its signal handlers.
  void StartAgain();

 private:
  const HangUp hang_up_;
  const bool hears_hang_up_;
};

}  // namespace openr_host
