// Ends the run in a signal handler because the code of an object does not return.  The class
// Watchdog (watchdog.h) and Ctrl-C that comes twice (interrupt_limit.h) do so.
#pragma once

#include <cstdint>

#include "openr/ending/signal_text.h"
#include "runtime/core/run_end.h"

namespace openr_host {

// Returns a number for the work that the current object of this thread does: another number for
// each message that an object handles, and for each object whose image is loaded or unloaded.
// Returns 0 if no object works.
uint64_t CurrentWork();

// Ends the process with status 1 and names the handler that runs on this thread, or the image that
// is loaded or unloaded.  `why` goes on after the name of the handler, such as " has used more than
// 10 s of processor time".  REQUIRES: CurrentWork() is not 0, and the signal handler may end the
// process now (DeferredEnd).
[[noreturn]] void EndCurrentWork(EndKind kind, const SignalText& why);

}  // namespace openr_host
