#include "openr/crash_log.h"

#include <fcntl.h>
#include <signal.h>
#include <sys/syscall.h>
#include <unistd.h>

#include "openr/last_words.h"
#include "openr/signal_text.h"
#include "runtime/core/current.h"
#include "runtime/core/fiber.h"
#include "runtime/core/system.h"

#if defined(__SANITIZE_ADDRESS__)
#define OPENR_ASAN 1
#elif defined(__has_feature)
#if __has_feature(address_sanitizer)
#define OPENR_ASAN 1
#endif
#endif
#ifndef OPENR_ASAN
#define OPENR_ASAN 0
#endif

namespace openr_host {
namespace {

constexpr int kSignals[] = {SIGSEGV, SIGBUS, SIGFPE, SIGILL};
constexpr size_t kAlternateStackBytes = 256 << 10;  // a report is made on it

// Paths of the files, by robot; fixed before the run.
std::vector<std::string>* g_files = nullptr;
char g_stack[kAlternateStackBytes];

const char* NameOf(int signal) {
  switch (signal) {
    case SIGSEGV:
      return "SIGSEGV (an address that is not the object's)";
    case SIGBUS:
      return "SIGBUS (an address that cannot be)";
    case SIGFPE:
      return "SIGFPE (a division by zero)";
    default:
      return "SIGILL (no instruction)";
  }
}

void WriteRecord(const SignalText& text, int robot) {
  text.WriteTo(STDERR_FILENO);
  if (g_files == nullptr || robot < 0 || static_cast<size_t>(robot) >= g_files->size()) return;
  const std::string& file = (*g_files)[static_cast<size_t>(robot)];
  if (file.empty()) return;
  // Not open(): that of this process may act for an object.
  const long descriptor =
      syscall(SYS_openat, AT_FDCWD, file.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0666);
  if (descriptor < 0) return;
  text.WriteTo(static_cast<int>(descriptor));
  SignalText note;
  note.Add("openr: wrote ").Add(file.c_str()).Add("\n").WriteTo(STDERR_FILENO);
}

void Crashed(int signal, siginfo_t* info, void*) {
  Ending ending;
  SignalText& text = ending.record;
  text.Add("EXCEPTION ").Add(NameOf(signal));
  text.Add(" at address 0x").AddNumber(reinterpret_cast<uint64_t>(info->si_addr), 16).Add("\n");
  text.Add("OBJECT ");
  if (!AddCurrentHandler(&text)) {  // the program's own fault
    struct sigaction action {};
    action.sa_handler = SIG_DFL;
    sigaction(signal, &action, nullptr);
    return;  // the instruction fails again, now as the system wants it
  }
  text.Add("\n");
  ending.finding.Add("crash: ").Add(NameOf(signal)).Add(" in ");
  AddCurrentEntry(&ending.finding);
  if (Fiber::AnyGuardContains(info->si_addr)) {
    const uint64_t kib = Fiber::kStackBytes >> 10;
    text.Add("STACK overflow: the handler used more than ").AddNumber(kib);
    text.Add(" KiB of stack\n");
    ending.finding.Add(", a stack overflow: more than ").AddNumber(kib).Add(" KiB");
  }
  ending.finding.Add("; on the robot this stops all objects");
  const int robot = t_current.object->robot;
  BeginEnding(&ending);
  WriteRecord(text, robot);
  FinishEnding();
}

void UseAlternateStack(bool on) {
  stack_t stack{};
  stack.ss_sp = g_stack;
  stack.ss_size = sizeof g_stack;
  stack.ss_flags = on ? 0 : SS_DISABLE;
  sigaltstack(&stack, nullptr);
}

}  // namespace

CrashLog::CrashLog(const std::vector<std::string>& sticks) {
  g_files = new std::vector<std::string>;
  for (const std::string& stick : sticks) {
    g_files->push_back(stick.empty() ? "" : stick + "/OPEN-R/EMON.LOG");
  }
  if constexpr (OPENR_ASAN) return;
  UseAlternateStack(true);
  struct sigaction action {};
  action.sa_sigaction = &Crashed;
  action.sa_flags = SA_SIGINFO | SA_ONSTACK;
  sigemptyset(&action.sa_mask);
  for (const int signal : kSignals) sigaction(signal, &action, nullptr);
}

CrashLog::~CrashLog() {
  if constexpr (!OPENR_ASAN) {
    for (const int signal : kSignals) ::signal(signal, SIG_DFL);
    UseAlternateStack(false);
  }
  delete g_files;
  g_files = nullptr;
}

}  // namespace openr_host
