// Counts Ctrl-C, SIGTERM and SIGHUP.  The run looks at the count between frames.
#pragma once

namespace openr_host {

// The effect on this process of a terminal that closes (SIGHUP).
enum class HangUp {
  kEnds,     // ends the process, the default action
  kCounts,   // the same as Ctrl-C
  kIgnored,  // nothing, because the work ends by itself
};

// While an InterruptCounter exists, SIGINT and SIGTERM are only counted.  The third signal ends the
// process at once, in case the run does not end.
class InterruptCounter {
 public:
  explicit InterruptCounter(HangUp hang_up = HangUp::kEnds);
  ~InterruptCounter();
  InterruptCounter(const InterruptCounter&) = delete;
  InterruptCounter& operator=(const InterruptCounter&) = delete;

  int count() const;

 private:
  const bool hears_hang_up_;
};

}  // namespace openr_host
