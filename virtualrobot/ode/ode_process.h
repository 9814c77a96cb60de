// ODE's process-wide parts, kept from making one world depend on another.
#pragma once

#include <cstdint>

namespace openr_host {

// Initialises ODE once per process, without threads: its thread pool is not repeatable.
void InitOde();

// While it lives, ODE's random generator belongs to one world: it starts from *seed and
// leaves its last value there; what other worlds had is put back.  Resetting the generator
// to a constant before each step instead would make the solvers try the same order for
// ever, which ruins convergence.
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
