#include "virtualrobot/ode/ode_process.h"

#include <ode/ode.h>

namespace openr_host {

void InitOde() {
  static const int initialised = dInitODE2(0);
  static_cast<void>(initialised);
}

OdeRandomScope::OdeRandomScope(uint64_t* seed) : seed_(seed), others_(dRandGetSeed()) {
  dRandSetSeed(*seed_);
}

OdeRandomScope::~OdeRandomScope() {
  *seed_ = dRandGetSeed();
  dRandSetSeed(others_);
}

}  // namespace openr_host
