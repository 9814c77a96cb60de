// Ctrl-C, SIGTERM and a terminal that closes, as a count to look at between frames.
#pragma once

namespace openr_host {

// The meaning of a terminal that closes (SIGHUP).
enum class HangUp {
  kEnds,     // the end of the process, as without us
  kCounts,   // the same as Ctrl-C
  kIgnored,  // nothing: the work comes to an end by itself
};

// While it lives, SIGINT and SIGTERM are only counted; the third ends the process at once, should
// the run not come to an end by itself.
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
