#include "runtime/core/arithmetic_watch.h"

#include "runtime/base/assert.h"
#include "runtime/core/fp_flags.h"
#include "runtime/core/memory_tools.h"

namespace openr_host {
namespace {

bool g_catches = false;

// Ends SIGFPE for floating-point operations, and sets the rounding mode to the nearest number.
// `x87` is the present control word of the old coprocessor.  Setting this control word is slow, so
// it is set only if an image has changed it.
void EndOwnState(uint16_t x87) {
  EndFpTraps();
  if (x87 != kX87Start) [[unlikely]]
    SetX87State(kX87Start);
}

}  // namespace

void ArithmeticWatch::SetCatches(bool on) { g_catches = on; }

bool ArithmeticWatch::Catches() { return g_catches && !IsStackWatched(); }

void ArithmeticWatch::Begin(unsigned kinds) {
  has_begun_ = true;
  if (!Catches()) return;
  kinds_ = kinds;
  SetFpTraps(kinds_);
}

void ArithmeticWatch::Pause() {
  if (++calls_ > 1) return;
  saved_fp_ = FpState();
  saved_x87_ = X87State();
  EndOwnState(saved_x87_);
}

void ArithmeticWatch::Resume() {
  ASSERT(calls_ > 0, "Resume() without Pause()");
  if (--calls_ > 0) return;
  SetFpState(saved_fp_);
  if (saved_x87_ != kX87Start) [[unlikely]]
    SetX87State(saved_x87_);
}

void ArithmeticWatch::End() { EndOwnState(X87State()); }

}  // namespace openr_host
