// Sections of code that a signal handler must not interrupt to end the process.
//
// The code holds a lock that the end of the process takes too, so an end in the middle of the code
// would wait for ever.
#pragma once

namespace openr_host {

// While an Indivisible exists, a signal handler puts off the end of the process; the destructor of
// the outermost one then ends the process.  Only for the thread that runs handlers.
class Indivisible {
 public:
  Indivisible();
  ~Indivisible();  // does not return if it ends the process
  Indivisible(const Indivisible&) = delete;
  Indivisible& operator=(const Indivisible&) = delete;

  // Called in a signal handler of that thread.  Returns true if an Indivisible exists; its
  // destructor will call `end`.  False: the signal handler may end the process itself.
  static bool PutOff(void (*end)());
};

}  // namespace openr_host
