// Sections of code that a signal handler must not interrupt to end the process.
//
// Such code holds a lock that the end of the process takes too, so an end in the middle of this
// code would wait for ever.
#pragma once

namespace openr_host {

// While an Indivisible exists, a signal handler puts off the end of the process; the destructor of
// the outermost one then ends the process.  Only for the thread that runs handlers.
class Indivisible {
 public:
  Indivisible();
  ~Indivisible();  // does not return if the destructor ends the process
  Indivisible(const Indivisible&) = delete;
  Indivisible& operator=(const Indivisible&) = delete;

  // Returns true if an Indivisible exists, whose destructor will then call `end`.  Returns false if
  // the signal handler may end the process itself.  Called in a signal handler of the thread that
  // runs handlers.
  static bool PutOff(void (*end)());
};

}  // namespace openr_host
