#include "openr/interrupt.h"

#include <signal.h>
#include <unistd.h>

#include "openr/exit_code.h"

namespace openr_host {
namespace {

volatile sig_atomic_t g_count = 0;

void Count(int) {
  g_count = g_count + 1;
  if (g_count < 3) return;
  static constexpr char kText[] =
      "ended by signal: Ctrl-C or SIGTERM came three times; no report is written\n";
  [[maybe_unused]] const ssize_t written = write(STDERR_FILENO, kText, sizeof kText - 1);
  _exit(kExitWrong);
}

void Install(void (*handler)(int)) {
  struct sigaction action {};
  action.sa_handler = handler;
  // On the alternate stack: an object may be using up its own.
  action.sa_flags = handler == SIG_DFL ? 0 : SA_ONSTACK;
  sigemptyset(&action.sa_mask);
  sigaction(SIGINT, &action, nullptr);
  sigaction(SIGTERM, &action, nullptr);
}

}  // namespace

InterruptCounter::InterruptCounter() {
  g_count = 0;
  Install(&Count);
}

InterruptCounter::~InterruptCounter() { Install(SIG_DFL); }

int InterruptCounter::count() const { return g_count; }

}  // namespace openr_host
