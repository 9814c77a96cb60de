// What must not be found half done by a signal handler that ends the process: it would wait for
// ever for what the interrupted code holds.
#pragma once

namespace openr_host {

// While one lives, endings of the process that a signal wants are put off; the last one to go does
// them.  For the thread that runs handlers.
class Indivisible {
 public:
  Indivisible();
  ~Indivisible();  // may not return
  Indivisible(const Indivisible&) = delete;
  Indivisible& operator=(const Indivisible&) = delete;

  // In a signal handler of that thread: whether one lives, and will call `end`.
  static bool PutOff(void (*end)());
};

}  // namespace openr_host
