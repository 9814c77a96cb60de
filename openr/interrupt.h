// Ctrl-C and SIGTERM as a count to look at between frames.
#pragma once

namespace openr_host {

// While it lives, both signals are only counted; the third ends the process at once, should the
// run not come to an end by itself.
class InterruptCounter {
 public:
  InterruptCounter();
  ~InterruptCounter();
  InterruptCounter(const InterruptCounter&) = delete;
  InterruptCounter& operator=(const InterruptCounter&) = delete;

  int count() const;
};

}  // namespace openr_host
