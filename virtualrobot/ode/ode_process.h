// Keeps worlds of ODE independent of each other, although a process has one ODE.
#pragma once

#include <cstdint>

namespace openr_host {

// Initialises ODE once per process, without threads: its thread pool is not repeatable.
void InitOde();

// Gives ODE's random generator to one world for the life of this object: the generator starts from
// *seed and its last value is stored there.  The destructor puts back the value of the other
// worlds. The generator is not reset to a constant before each step, because the solvers would then
// try the same order in every step and converge badly.
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
