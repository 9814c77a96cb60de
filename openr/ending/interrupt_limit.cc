#include "openr/ending/interrupt_limit.h"

#include <signal.h>
#include <unistd.h>

#include <cstdint>

#include "openr/ending/ending.h"
#include "openr/ending/endless_work.h"
#include "openr/ending/signal_text.h"
#include "runtime/core/current.h"
#include "runtime/core/deferred_end.h"

namespace openr_host {
namespace {

// A handler that runs for this time after the second Ctrl-C is ended.  A handler of a run that is
// well ends much earlier, so such a run still ends between two frames, as docs/cli.md says.
constexpr unsigned kInterruptLimitS = 1;

volatile sig_atomic_t g_limit_runs = 0;
// The work that was done when SIGALRM was last ordered (CurrentWork()).
uint64_t g_work_at_alarm = 0;

// While a HostScope exists, calls of the C library are calls of this program.  Without it,
// sigaction() and alarm() in a signal handler that has interrupted code of an object would be
// refused, as calls of this object.
class HostScope {
 public:
  HostScope() { t_current.image_code = false; }
  ~HostScope() { t_current.image_code = was_image_code_; }
  HostScope(const HostScope&) = delete;
  HostScope& operator=(const HostScope&) = delete;

 private:
  const bool was_image_code_ = t_current.image_code;
};

void EndTheInterruptedWork() {
  SignalText why;
  why.Add(" still ran ").AddNumber(kInterruptLimitS);
  why.Add(" s after Ctrl-C or SIGTERM had come twice");
  // The work may have ended while a DeferredEnd delayed this call.  The run then ends after the
  // present frame.
  if (CurrentWork() == g_work_at_alarm) EndCurrentWork(EndKind::kSignal, why);
}

// Handles SIGALRM, which comes kInterruptLimitS after the second Ctrl-C.  Orders SIGALRM again if
// other work is done now, because that may not return either.  Also does so if this is not the
// thread that runs handlers: CurrentWork() is 0 there.
void OnInterruptAlarm(int) {
  const uint64_t work = CurrentWork();
  if (work != 0 && work == g_work_at_alarm && !DeferredEnd::Defer(&EndTheInterruptedWork))
    EndTheInterruptedWork();
  if (work != 0) g_work_at_alarm = work;
  const HostScope scope;
  alarm(kInterruptLimitS);
}

}  // namespace

void StartInterruptLimit() {
  // BeginEnding() uses SIGALRM for its own time limit.
  if (HasEndingBegun()) return;
  g_work_at_alarm = CurrentWork();
  g_limit_runs = 1;
  const HostScope scope;
  struct sigaction action {};
  action.sa_handler = &OnInterruptAlarm;
  action.sa_flags = SA_ONSTACK | SA_RESTART;
  sigemptyset(&action.sa_mask);
  sigaction(SIGALRM, &action, nullptr);
  alarm(kInterruptLimitS);
}

void StopInterruptLimit() {
  if (g_limit_runs == 0) return;
  g_limit_runs = 0;
  alarm(0);
  ::signal(SIGALRM, SIG_DFL);
}

}  // namespace openr_host
