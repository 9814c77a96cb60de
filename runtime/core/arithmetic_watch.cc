#include "runtime/core/arithmetic_watch.h"

#include "runtime/base/assert.h"
#include "runtime/core/fp_flags.h"
#include "runtime/core/memory_tools.h"

namespace openr_host {
namespace {

bool g_catches = false;

}  // namespace

void ArithmeticWatch::SetCatches(bool on) { g_catches = on; }

bool ArithmeticWatch::Catches() { return g_catches && !IsStackWatched(); }

void ArithmeticWatch::Begin(unsigned kinds) {
  has_begun_ = true;
  kinds_ = kinds;
  SetFpTraps(kinds_);
}

void ArithmeticWatch::Pause() {
  if (++calls_ > 1) return;
  saved_fp_ = FpState();
  EndFpTraps();
}

void ArithmeticWatch::Resume() {
  ASSERT(calls_ > 0, "Resume() without Pause()");
  if (--calls_ == 0) SetFpState(saved_fp_);
}

void ArithmeticWatch::End() { EndFpTraps(); }

}  // namespace openr_host
