#include "openr/ending/watchdog.h"

#include <signal.h>
#include <sys/syscall.h>
#include <time.h>
#include <unistd.h>

#include <algorithm>

#include "openr/ending/endless_work.h"
#include "openr/ending/signal_text.h"
#include "runtime/core/deferred_end.h"
#include "runtime/core/run_end.h"

namespace openr_host {
namespace {

constexpr int kSignal = SIGVTALRM;
// Number of times that a handler is checked within its time limit; so a handler is ended at most
// 1/8 of the limit too late.
constexpr int kTicks = 8;

timer_t g_timer;
uint64_t g_limit_us = 0;
const char* g_flag = "";  // the flag of the command that sets the limit; "": none
uint64_t g_work = 0;      // the work that was done at the last check (CurrentWork())
int g_seen = 0;           // number of checks in a row at which g_work was still done

// Adds `us` microseconds to `text` as seconds, with at least one digit after the point: "2.0",
// "0.05".
void AddSeconds(uint64_t us, SignalText* text) {
  constexpr uint64_t kTenthUs = 100'000;
  text->AddNumber(us / 1'000'000).Add(".");
  uint64_t rest_us = us % 1'000'000;
  for (uint64_t unit_us = kTenthUs; unit_us == kTenthUs || rest_us > 0; unit_us /= 10) {
    text->AddNumber(rest_us / unit_us);
    rest_us %= unit_us;
  }
}

void EndTheHandler() {
  SignalText why;
  why.Add(" has used more than ");
  AddSeconds(g_limit_us, &why);
  why.Add(" s of processor time");
  if (*g_flag != 0) why.Add(" (").Add(g_flag).Add(")");
  EndCurrentWork(EndKind::kHandlerLimit, why);
}

// Handles SIGVTALRM, which comes each time this thread has used 1/kTicks of the time limit.  Ends
// the process when kTicks + 1 of these signals in a row have come during the same work.  One more
// than kTicks is needed, because the work may have begun just before the first signal.
void OnTickSignal(int) {
  const uint64_t work = CurrentWork();
  g_seen = work != 0 && work == g_work ? g_seen + 1 : 0;
  g_work = work;
  if (g_seen >= kTicks && !DeferredEnd::Defer(&EndTheHandler)) EndTheHandler();
}

}  // namespace

Watchdog::Watchdog(int64_t limit_us, const char* flag) : limit_us_(limit_us) {
  g_flag = flag;
  if (limit_us <= 0) return;
  g_limit_us = static_cast<uint64_t>(limit_us);
  g_work = 0;
  g_seen = 0;
  struct sigaction action {};
  action.sa_handler = &OnTickSignal;
  action.sa_flags = SA_ONSTACK | SA_RESTART;
  sigemptyset(&action.sa_mask);
  sigaction(kSignal, &action, nullptr);
  armed_ = StartTimer();
}

// Starts the timer of the thread that made the Watchdog.  Returns false if the operating system has
// no such timers.
bool Watchdog::StartTimer() const {
  sigevent event{};
  event.sigev_notify = SIGEV_THREAD_ID;
  event.sigev_signo = kSignal;
  event._sigev_un._tid = static_cast<pid_t>(syscall(SYS_gettid));
  if (timer_create(CLOCK_THREAD_CPUTIME_ID, &event, &g_timer) != 0) return false;
  const int64_t tick_ns = std::max<int64_t>(limit_us_ * 1000 / kTicks, 1'000'000);
  itimerspec period{};
  period.it_interval = {tick_ns / 1'000'000'000, tick_ns % 1'000'000'000};
  period.it_value = period.it_interval;
  timer_settime(g_timer, 0, &period, nullptr);
  return true;
}

void Watchdog::StartAgain() {
  g_seen = 0;
  if (armed_) armed_ = StartTimer();
}

Watchdog::~Watchdog() {
  if (!armed_) return;
  timer_delete(g_timer);
  // Ignores the signal of the timer, because the signal may come once more and would end the
  // process.
  ::signal(kSignal, SIG_IGN);
}

}  // namespace openr_host
