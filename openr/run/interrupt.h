// InterruptCounter, which counts Ctrl-C, SIGTERM and SIGHUP.  The run reads the count after each
// frame.
#pragma once

namespace openr_host {

// The effect of SIGHUP on this process.  The signal comes when its terminal is closed.
enum class HangUp {
  kEnds,     // ends the process, which is the signal's default
  kCounts,   // is counted like Ctrl-C
  kIgnored,  // has none, because the run ends by itself
};

// While an InterruptCounter exists, SIGINT and SIGTERM do not end the process but are counted.  The
// third one ends the process at once, in case the run hangs.
class InterruptCounter {
 public:
  explicit InterruptCounter(HangUp hang_up = HangUp::kEnds);
  ~InterruptCounter();
  InterruptCounter(const InterruptCounter&) = delete;
  InterruptCounter& operator=(const InterruptCounter&) = delete;

  int count() const;

  // Begins to count again from 0, in a fork of the process that has changed what signals do.
  void StartAgain();

 private:
  const HangUp hang_up_;
  const bool hears_hang_up_;
};

}  // namespace openr_host
