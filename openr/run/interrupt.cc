#include "openr/run/interrupt.h"

#include <signal.h>
#include <unistd.h>

#include "cli/exit_code.h"
#include "openr/ending/interrupt_limit.h"
#include "runtime/core/current.h"

namespace openr_host {
namespace {

volatile sig_atomic_t g_count = 0;

// Counts SIGINT, SIGTERM and SIGHUP.  From the second of these signals on, a handler of an object
// that does not return within 1 s ends the process.  Ends the process itself at the third signal,
// in case the run hangs.
void OnInterruptSignal(int) {
  g_count = g_count + 1;
  if (g_count == 2) StartInterruptLimit();
  if (g_count < 3) return;
  static constexpr char kText[] =
      "ended by signal: Ctrl-C or SIGTERM came three times; no report is written\n";
  [[maybe_unused]] const ssize_t written = write(STDERR_FILENO, kText, sizeof kText - 1);
  // Clears t_current, because _exit() would otherwise end only the handler of the object that runs.
  t_current = {};
  _exit(kExitWrong);
}

void Install(int signal, void (*handler)(int)) {
  struct sigaction action {};
  action.sa_handler = handler;
  // Our handler runs on the alternate signal stack, because the signal may interrupt an object that
  // has used up its own stack.  SIG_DFL and SIG_IGN are no functions and need no stack.
  action.sa_flags = handler == &OnInterruptSignal ? SA_ONSTACK : 0;
  sigemptyset(&action.sa_mask);
  sigaction(signal, &action, nullptr);
}

// Returns whether this process has ignored `signal` from its start, as a process under nohup
// ignores SIGHUP.  The signal then stays ignored, because the user wants that.
bool IsIgnored(int signal) {
  struct sigaction action {};
  return sigaction(signal, nullptr, &action) == 0 && action.sa_handler == SIG_IGN;
}

}  // namespace

InterruptCounter::InterruptCounter(HangUp hang_up)
    : hang_up_(hang_up), hears_hang_up_(hang_up != HangUp::kEnds && !IsIgnored(SIGHUP)) {
  StartAgain();
}

void InterruptCounter::StartAgain() {
  g_count = 0;
  StopInterruptLimit();
  alarm(0);  // looks up the C library's alarm(), which a signal handler may call next
  Install(SIGINT, &OnInterruptSignal);
  Install(SIGTERM, &OnInterruptSignal);
  if (hears_hang_up_) Install(SIGHUP, hang_up_ == HangUp::kCounts ? &OnInterruptSignal : SIG_IGN);
}

InterruptCounter::~InterruptCounter() {
  StopInterruptLimit();
  Install(SIGINT, SIG_DFL);
  Install(SIGTERM, SIG_DFL);
  if (hears_hang_up_) Install(SIGHUP, SIG_DFL);
}

int InterruptCounter::count() const { return g_count; }

}  // namespace openr_host
