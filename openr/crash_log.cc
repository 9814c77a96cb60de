#include "openr/crash_log.h"

#include <fcntl.h>
#include <signal.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <filesystem>
#include <system_error>
#include <utility>

#include "openr/crash_stack.h"
#include "openr/last_words.h"
#include "openr/signal_text.h"
#include "runtime/core/current.h"
#include "runtime/core/stack_memory.h"
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
bool g_adds = false;
std::optional<std::string>* g_place = nullptr;  // see CrashLog; none: the file is not named
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

// Null when the robot has no file.
const std::string* FileOf(int robot) {
  if (g_files == nullptr || robot < 0 || static_cast<size_t>(robot) >= g_files->size())
    return nullptr;
  const std::string& file = (*g_files)[static_cast<size_t>(robot)];
  return file.empty() ? nullptr : &file;
}

// What happened first, since the stack, which is added, may be too damaged to be walked.
void WriteRecord(Ending* ending, const void* context, int robot) {
  const std::string* const file = FileOf(robot);
  // Not open(): that of this process may act for an object.
  const auto descriptor =
      file == nullptr
          ? -1
          : static_cast<int>(syscall(SYS_openat, AT_FDCWD, file->c_str(),
                                     O_WRONLY | O_CREAT | (g_adds ? O_APPEND : O_TRUNC), 0666));
  const auto write = [descriptor](const SignalText& text) {
    text.WriteTo(STDERR_FILENO);
    if (descriptor >= 0) text.WriteTo(descriptor);
  };
  write(ending->record);
  const CrashStack stack(*ending->object, context);
  SignalText frames;
  stack.AddTo(&frames);
  write(frames);
  ending->record.Add(frames.text());
  stack.AddPlace(&ending->finding);
  if (descriptor < 0) return;
  SignalText note;
  note.Add("openr: wrote ").Add(*file).Add("\n").WriteTo(STDERR_FILENO);
  if (g_place->has_value()) ending->finding.Add("; record: ").Add(*file).Add(**g_place);
}

void Crashed(int signal, siginfo_t* info, void* context) {
  Ending ending;
  SignalText& text = ending.record;
  text.Add("EXCEPTION ").Add(NameOf(signal));
  const bool is_overflow = StackMemory::AnyGuardContains(info->si_addr);
  // That of an instruction, or in the guard, is another one in each run; the stack says where.
  if ((signal == SIGSEGV || signal == SIGBUS) && !is_overflow)
    text.Add(" at address 0x").AddNumber(reinterpret_cast<uint64_t>(info->si_addr), 16);
  text.Add("\nOBJECT ");
  if (!AddCurrentHandler(&text)) {  // the program's own fault
    struct sigaction action {};
    action.sa_handler = SIG_DFL;
    sigaction(signal, &action, nullptr);
    return;  // the instruction fails again, now as the system wants it
  }
  text.Add("\n");
  ending.finding.Add("crash: ").Add(NameOf(signal)).Add(" in ");
  AddCurrentEntry(&ending.finding);
  if (is_overflow) {
    const uint64_t kib = StackMemory::kBytes >> 10;
    text.Add("STACK overflow: the handler used more than ").AddNumber(kib);
    text.Add(" KiB of stack\n");
    ending.finding.Add(", a stack overflow: more than ").AddNumber(kib).Add(" KiB");
  }
  const int robot = t_current.object->robot;
  BeginEnding(&ending);
  WriteRecord(&ending, context, robot);
  ending.finding.Add("; on the robot this stops all objects");
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

CrashLog::CrashLog(std::vector<std::string> files, bool adds,
                   const std::optional<std::string>& place) {
  g_adds = adds;
  g_place = new std::optional<std::string>(place);
  g_files = new std::vector<std::string>(std::move(files));
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
  delete g_place;
  g_files = nullptr;
  g_place = nullptr;
}

void CrashLog::BeginAfresh(const std::string& file) {
  std::error_code error;  // it is not there, or may not be written: then no record is added either
  std::filesystem::remove(file, error);
}

}  // namespace openr_host
