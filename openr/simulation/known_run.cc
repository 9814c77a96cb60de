#include "openr/simulation/known_run.h"

#include "openr/simulation/simulation.h"
#include "runtime/core/system.h"

namespace openr_host {

void KnownRun::RunUntil(int64_t time_us) {
  System& system = simulation().system();
  for (;;) {
    const int64_t before_us = system.now_us();
    const uint64_t messages = system.message_count();
    RunOne(time_us);
    if (system.now_us() == before_us && system.message_count() == messages) return;
  }
}

}  // namespace openr_host
