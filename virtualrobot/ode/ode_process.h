// Keeps the worlds of ODE independent of each other, although a process has only one state of ODE.
#pragma once

#include <cstdint>

namespace openr_host {

// Initialises ODE once per process.  It runs without threads, because the results of its thread
// pool are not repeatable.
void InitOde();

// Gives ODE's random generator to one world for the lifetime of this object.  The constructor sets
// the generator to *seed.  The destructor stores the generator's state in *seed and restores the
// state that the generator had before.  The generator is not reset to a constant before each step,
// because the solvers would then try the same order in every step and converge badly.
class OdeRandomScope {
 public:
  explicit OdeRandomScope(uint64_t* seed);
  ~OdeRandomScope();
  OdeRandomScope(const OdeRandomScope&) = delete;
  OdeRandomScope& operator=(const OdeRandomScope&) = delete;

 private:
  uint64_t* seed_;
  uint64_t others_;
};

}  // namespace openr_host
