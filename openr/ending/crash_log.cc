#include "openr/ending/crash_log.h"

#include <fcntl.h>
#include <signal.h>
#include <sys/syscall.h>
#include <ucontext.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <charconv>
#include <cstring>
#include <filesystem>
#include <iterator>
#include <optional>
#include <system_error>
#include <vector>

#include "cli/output_file.h"
#include "openr/ending/code_lookup.h"
#include "openr/ending/crash_stack.h"
#include "openr/ending/end_guards.h"
#include "openr/ending/ending.h"
#include "openr/ending/integer_division.h"
#include "openr/ending/robot_record.h"
#include "openr/ending/signal_text.h"
#include "runtime/base/assert.h"
#include "runtime/core/code_place.h"
#include "runtime/core/current.h"
#include "runtime/core/fp_flags.h"
#include "runtime/core/guard_pages.h"
#include "runtime/core/memory_tools.h"
#include "runtime/core/robot_fault.h"
#include "runtime/core/stack_memory.h"
#include "runtime/core/system.h"

#if defined(__SANITIZE_ADDRESS__)
#define OPENR_ASAN 1
#else
#define OPENR_ASAN 0
#endif

namespace openr_host {
namespace {

constexpr int kCrashSignals[] = {SIGSEGV, SIGBUS, SIGFPE, SIGILL, SIGTRAP, SIGABRT};
// Size of the stack on which the signal handler runs, large enough for all functions that report a
// crash.
constexpr size_t kAlternateStackBytes = 256 << 10;

// The options of the CrashLog; null while no CrashLog exists.
const EndGuardOptions* g_record_options = nullptr;
char g_stack[kAlternateStackBytes];
// The actions and the stack that the CrashLog has replaced; its destructor restores them.
struct sigaction g_replaced_actions[std::size(kCrashSignals)];
stack_t g_replaced_stack{};

// Returns the kind of floating-point error (FpFlag) that caused the SIGFPE; 0 if a division of
// integers caused it.
unsigned KindOf(const siginfo_t& info) {
  switch (info.si_code) {
    case FPE_FLTINV:
      return kFpInvalid;
    case FPE_FLTDIV:
      return kFpDivByZero;
    case FPE_FLTOVF:
      return kFpOverflow;
    case FPE_FLTUND:  // means a denormal operand; an underflow is masked, so it raises no SIGFPE
      return kFpDenormal;
    default:
      return 0;
  }
}

const char* MeaningOfAddress(const siginfo_t& info, const void* context) {
  const GuardPages* const guard = t_current.system->guard_pages();
  const char* const why = guard == nullptr ? "" : guard->FaultText(info.si_addr);
  if (*why != 0) return why;
#if defined(__x86_64__)
  const auto& registers = static_cast<const ucontext_t*>(context)->uc_mcontext.gregs;
  constexpr uintptr_t kFirstPages = 0x10000;
  const auto at = reinterpret_cast<uintptr_t>(info.si_addr);
  if (at >= kFirstPages && at == static_cast<uintptr_t>(registers[REG_RIP]))
    return "data were executed";
#else
  static_cast<void>(context);
#endif
  return "an address that is not the object's";
}

// Returns whether the processor has refused an address without telling it, so that Linux gives
// si_addr = 0 (SI_KERNEL).  x86-64 processors do so with an address whose upper 17 bits are not
// all equal, such as 0x7070707070707070, and with an address that is not aligned for its
// instruction.
bool HasHiddenAddress(const siginfo_t& info) { return info.si_code == SI_KERNEL; }

// Returns the name and the cause of a SIGFPE.
const char* MeaningOfArithmetic(const siginfo_t& info, const void* context) {
  switch (KindOf(info)) {
    case 0:
      return IsSmallestByMinusOne(*static_cast<const ucontext_t*>(context))
                 ? "SIGFPE (the smallest integer divided by -1, at which the robot would go on)"
                 : "SIGFPE (a division by zero)";
    case kFpDenormal:
      return "SIGFPE (a denormal number was used)";
    default:
      return "SIGFPE (a NaN was made, or a number does not fit its integer type)";
  }
}

// Adds the name and the cause of the signal to `text`, such as "SIGSEGV (an address that is not the
// object's)".  REQUIRES: a handler of an object runs.
void AddName(int signal, const siginfo_t& info, const void* context, SignalText* text) {
  switch (signal) {
    case SIGSEGV:
      text->Add("SIGSEGV (").Add(MeaningOfAddress(info, context)).Add(")");
      break;
    case SIGBUS:
      text->Add("SIGBUS (an address that cannot be)");
      break;
    case SIGFPE:
      text->Add(MeaningOfArithmetic(info, context));
      break;
    case SIGTRAP:
      text->Add("SIGTRAP (a breakpoint in the code)");
      break;
    case SIGABRT:
      text->Add(
              "SIGABRT (the C library ended the process: it found the object's heap, a stream or ")
          .Add("the stack damaged)");
      break;
    default:
      if (*AnnouncedFault() != 0) {
        text->Add(AnnouncedFault());
      } else {
        text->Add("SIGILL (no instruction)");
      }
      break;
  }
}

// Lets the code of an image go on after it has divided the smallest integer by -1, because the
// robot does not stop there.  Stores the address of the instruction for the warning, which
// ImageObject adds when the handler has returned.  Returns false for another division, and for a
// division of code that is not in an image: there it is an error of the runtime.
bool ContinueAfterDivision(void* context) {
  if (!t_current.image_code) return false;
  Object* const object = t_current.object;
  const CrashStack stack(*object, context);
  if (!DivideAsTheRobotDoes(static_cast<ucontext_t*>(context))) return false;
  object->number_faults().NoteTooLargeQuotient(stack.OwnAddress());
  return true;
}

// Lets the object go on after a floating-point error, because such an error is only a warning.
// Stores the address of the instruction for this warning, which ImageObject adds when the handler
// has returned.  Masks this kind of error, so that the instruction runs again without a signal.
// Returns false if the error must end the run: a division of integers by 0 or, with --strict, a NaN
// or a denormal operand.
bool ContinueInSignal(const siginfo_t& info, void* context) {
#if defined(__x86_64__)
  const unsigned kind = KindOf(info);
  if (t_current.object == nullptr) return false;
  if (kind == 0) return ContinueAfterDivision(context);
  const bool stops_the_robot = kind == kFpInvalid || kind == kFpDenormal;
  if (stops_the_robot && t_current.system->options().strict) return false;
  const CrashStack stack(*t_current.object, context);
  t_current.object->number_faults().NoteInstruction(kind, stack.OwnAddress());
  static_cast<ucontext_t*>(context)->uc_mcontext.fpregs->mxcsr |= kind << kFpMaskShift;
  if (t_current.watch != nullptr) t_current.watch->DisableTrap(kind);
  return true;
#else
  static_cast<void>(info);
  static_cast<void>(context);
  return false;
#endif
}

// Returns the path of the file for crash records of `robot`; null if `robot` has no such file.
const std::string* FileOf(int robot) {
  const std::vector<std::string>& files = g_record_options->crash_logs;
  if (robot < 0 || static_cast<size_t>(robot) >= files.size()) return nullptr;
  const std::string& file = files[static_cast<size_t>(robot)];
  return file.empty() ? nullptr : &file;
}

// The file to which a crash record is written.  It is opened and written only with calls that are
// allowed in a signal handler.
class RecordFile {
 public:
  // Opens the file `name` for a crash record.  If `name` is null, no file is opened or written.
  explicit RecordFile(const std::string* name) : name_(name) {
    if (name == nullptr) return;
    const bool adds = g_record_options->adds_to_crash_logs;
    // Calls syscall() and not open(), because the runtime replaces open() in this process by a
    // function that may open a file of the object's Memory Stick instead.
    descriptor_ = static_cast<int>(syscall(SYS_openat, AT_FDCWD, name->c_str(),
                                           O_WRONLY | O_CREAT | (adds ? O_APPEND : O_TRUNC), 0666));
    if (descriptor_ < 0) error_ = errno;
    if (adds && descriptor_ >= 0) begin_ = std::max<off_t>(lseek(descriptor_, 0, SEEK_END), 0);
  }

  void Write(const SignalText& text) {
    if (descriptor_ < 0 || error_ != 0) return;
    error_ = WriteAll(descriptor_, text.text());
    if (error_ != 0) RemovePart();
  }

  // Prints on standard error that the crash record was written to its file, or why it was not
  // written.  Returns true if it was written.
  bool PrintWriteResult() const {
    if (name_ == nullptr) return false;
    SignalText note;
    if (error_ == 0) {
      note.Add("openr: wrote ").Add(*name_);
    } else {
      // Uses strerrordesc_np() of the GNU C library, because strerror() may allocate memory, which
      // is not allowed in a signal handler.
      const char* const why = strerrordesc_np(error_);
      note.Add("openr: ").Add(*name_).Add(": the record of the crash cannot be written: ");
      note.Add(why == nullptr ? "unknown error" : why);
    }
    note.Add("\n").WriteTo(STDERR_FILENO);
    return error_ == 0;
  }

 private:
  // Removes the written part of this crash record after a failed write, because programs that read
  // the file would take the part for the whole record.  Records of other processes in this file
  // stay.
  void RemovePart() const {
    if (begin_ > 0) {
      static_cast<void>(ftruncate(descriptor_, begin_) == 0);
    } else {
      syscall(SYS_unlinkat, AT_FDCWD, name_->c_str(), 0);
    }
  }

  const std::string* const name_;
  int descriptor_ = -1;
  off_t begin_ = 0;  // size of the file before this crash record was added
  int error_ = 0;    // errno of the first call that failed; 0: none failed
};

// Returns the code of the exception that the robot's processor raises for a SIGSEGV: 1 for a store
// to a page that may only be read, 3 for another store, 2 for a load or a jump.
unsigned MemoryExceptionCode(const void* context) {
  constexpr unsigned kReadOnlyPage = 1, kLoad = 2, kStore = 3;
#if defined(__x86_64__)
  // Bits of the error code with which the processor reports a page fault.
  constexpr greg_t kPageIsThere = 1, kIsStore = 2;
  const greg_t error = static_cast<const ucontext_t*>(context)->uc_mcontext.gregs[REG_ERR];
  if ((error & kIsStore) == 0) return kLoad;
  return (error & kPageIsThere) == 0 ? kStore : kReadOnlyPage;
#else
  static_cast<void>(context);
  static_cast<void>(kReadOnlyPage);
  static_cast<void>(kStore);
  return kLoad;
#endif
}

// Returns the code of the exception that the robot's processor raises for the signal
// (field-notes.md 4.1); 0 for an error that the robot's processor does not notice.
unsigned RobotExceptionCode(int signal, const siginfo_t& info, const void* context) {
  // If the runtime itself has found the fault, takes the exception code from the text with which
  // the runtime has announced the fault, such as "a division by zero at Dog.cc:5 (exception 9)".
  if (*AnnouncedFault() != 0) {
    static constexpr char kException[] = "(exception ";
    const char* const begin = std::strstr(AnnouncedFault(), kException);
    if (begin == nullptr) return 0;
    unsigned code = 0;
    std::from_chars(begin + sizeof kException - 1, begin + std::strlen(begin), code);
    return code;
  }
  constexpr unsigned kAddress = 4, kBreakpoint = 9, kReserved = 10, kFloat = 15;
  switch (signal) {
    case SIGSEGV:
      return MemoryExceptionCode(context);
    case SIGBUS:
      return kAddress;
    case SIGFPE:
      return KindOf(info) == 0 ? kBreakpoint : kFloat;
    case SIGTRAP:
      return kBreakpoint;
    case SIGABRT:
      return 0;  // the robot's C library does not look for such damage
    default:
      return kReserved;
  }
}

// Writes the crash record to standard error and to the file for crash records of the robot `robot`.
// Then adds the call stack to both.  Finally adds to the file the part in the robot's form, which
// needs the call stack.  The stack may be so damaged that walking it crashes again; the file then
// lacks these two parts.
void WriteRecordInSignal(Ending* ending, RobotException* exception, const void* context,
                         int robot) {
  const std::string* const name = FileOf(robot);
  RecordFile file(name);
  const auto write = [&file](const SignalText& text) {
    text.WriteTo(STDERR_FILENO);
    file.Write(text);
  };
  write(ending->record);
  const CrashStack stack(*ending->object, context);
  SignalText frames;
  stack.AddTo(&frames);
  write(frames);
  ending->record.Add(frames.text());
  exception->epc = stack.OwnOffset();
  WriteRobotRecord(*exception, *ending->object,
                   [&file](const SignalText& text) { file.Write(text); });
  stack.AddPlace(&ending->finding);
  const std::optional<std::string>& place = g_record_options->crash_log_place;
  if (file.PrintWriteResult() && place) ending->finding.Add("; record: ").Add(*name).Add(*place);
}

// Returns whether SIGABRT comes from a function of the C library that an object has called.  The
// abort() of an object itself sends no signal, but ends its handler (process_hooks.cc).  SIGABRT of
// code of the runtime (ASSERT) and of another process (kill) is no crash of an object.
bool IsAbortOfLibrary(const siginfo_t& info) {
  return t_current.object != nullptr && t_current.image_code && info.si_code == SI_TKILL;
}

// Makes `signal` end the process when its handler returns, as if it had no handler.
void TakeDefaultAction(int signal) {
  t_current = {};  // otherwise sigaction() would be refused if code of an object was running
  struct sigaction action {};
  action.sa_handler = SIG_DFL;
  sigaction(signal, &action, nullptr);
  // Sends the signal again, because nothing else repeats a signal of another process.
  syscall(SYS_tgkill, syscall(SYS_getpid), syscall(SYS_gettid), signal);
}

// Handles the signals of kCrashSignals.  Ends the process with a crash record if an object was
// running, unless ContinueInSignal() lets the object go on.
void OnCrashSignal(int signal, siginfo_t* info, void* context) {
  if (signal == SIGFPE && ContinueInSignal(*info, context)) return;
  if (signal == SIGABRT && !IsAbortOfLibrary(*info)) return TakeDefaultAction(signal);
  Ending ending;
  SignalText& text = ending.record;
  SignalText name;
  if (t_current.object != nullptr) AddName(signal, *info, context, &name);
  // AddName() fills `name`, which cppcheck does not see.
  // cppcheck-suppress uninitvar
  text.Add("EXCEPTION ").Add(name.text());
  // SIGABRT has no address: its siginfo_t has a process in the same place.
  const bool is_overflow = signal != SIGABRT && StackMemory::AnyGuardContains(info->si_addr);
  // Prints only an address that the object has accessed.  The address of the instruction (SIGFPE,
  // SIGILL) and an address just beyond a full stack differ from run to run, so they are left out;
  // the call stack in the crash record shows the place of the crash.
  const bool is_access = (signal == SIGSEGV || signal == SIGBUS) && !is_overflow;
  if (is_access && HasHiddenAddress(*info))
    text.Add(" at an address that this processor cannot use");
  else if (is_access)
    text.Add(" at address 0x").AddNumber(reinterpret_cast<uint64_t>(info->si_addr), 16);
  text.Add("\nOBJECT ");
  if (!AddCurrentHandler(&text)) {  // no object was running: the program itself has crashed
    struct sigaction action {};
    action.sa_handler = SIG_DFL;
    sigaction(signal, &action, nullptr);
    // After a breakpoint the code would go on behind it, so the signal is raised again.
    if (signal == SIGTRAP) raise(signal);
    return;  // the instruction runs again, and the signal's default action ends the process
  }
  text.Add("\n");
  AddCurrentMessage(&text);
  ending.finding.Add("crash: ").Add(name.text()).Add(" in ");
  AddCurrentEntry(&ending.finding);
  if (is_overflow) {
    const uint64_t kib = StackMemory::kBytes >> 10;
    text.Add("STACK overflow: the handler used more than ").AddNumber(kib);
    text.Add(" KiB of stack\n");
    ending.finding.Add(", a stack overflow: more than ").AddNumber(kib).Add(" KiB");
  }
  const int robot = t_current.object->robot;
  RobotException exception{.code = RobotExceptionCode(signal, *info, context),
                           .is_in_own_code = t_current.image_code};
  if (is_access)
    exception.bad_address =
        HasHiddenAddress(*info) ? kUnknownAddress : reinterpret_cast<uint64_t>(info->si_addr);
  BeginEnding(&ending);  // clears t_current, so the lines above read the running object first
  WriteRecordInSignal(&ending, &exception, context, robot);
  ending.finding.Add("; on the robot this stops all objects");
  FinishEnding();
}

void UseAlternateStack() {
  stack_t stack{};
  stack.ss_sp = g_stack;
  stack.ss_size = sizeof g_stack;
  sigaltstack(&stack, &g_replaced_stack);
}

// Ends the run after AddressSanitizer, which is in images of openr build --sanitize, has printed
// `report` about an error.  The report's first line is "==123==ERROR: AddressSanitizer:
// heap-use-after-free on address ...".  The text about the end of the run has only the kind of the
// error, here heap-use-after-free.
void OnSanitizerReport(const char* report) {
  // Does nothing if no object runs, because AddressSanitizer then ends the process itself.
  if (t_current.object == nullptr) return;
  static constexpr char kBegin[] = "AddressSanitizer: ";
  const char* const begin = std::strstr(report, kBegin);
  if (begin == nullptr) return;
  std::string_view rest = begin + sizeof kBegin - 1;
  // A word before the names of some errors, as in "attempting double-free on ...".  It is left out,
  // because it does not belong to the name.
  static constexpr std::string_view kAttempting = "attempting ";
  if (rest.starts_with(kAttempting)) rest.remove_prefix(kAttempting.size());
  StopAsTheRobotDoes("AddressSanitizer: " + std::string(rest.substr(0, rest.find_first_of(" \n"))));
}

}  // namespace

}  // namespace openr_host

#if !OPENR_ASAN
// AddressSanitizer calls this function before it prints a report.  Makes file functions use the
// files of the host instead of the files of the object, because AddressSanitizer reads debug
// information for its report.  Nothing undoes this, because the object does not run again.
extern "C" [[gnu::visibility("default")]] void __asan_on_error() {
  openr_host::t_current.image_code = false;
}
#endif

namespace openr_host {

CrashLog::CrashLog(const EndGuardOptions& options) {
  ASSERT(g_record_options == nullptr);  // only one CrashLog may exist at a time
  g_record_options = &options;
  if constexpr (OPENR_ASAN) return;
  UseAlternateStack();
  struct sigaction action {};
  action.sa_sigaction = &OnCrashSignal;
  action.sa_flags = SA_SIGINFO | SA_ONSTACK;
  sigemptyset(&action.sa_mask);
  for (size_t i = 0; i < std::size(kCrashSignals); ++i)
    sigaction(kCrashSignals[i], &action, &g_replaced_actions[i]);
  ArithmeticWatch::SetCatches(true);
  if (IsAddressSanitized()) __asan_set_error_report_callback(&OnSanitizerReport);
  SetPlaceNamer(&LineOfAddress);
}

CrashLog::~CrashLog() {
  if constexpr (!OPENR_ASAN) {
    ArithmeticWatch::SetCatches(false);
    SetPlaceNamer(nullptr);
    if (IsAddressSanitized()) __asan_set_error_report_callback(nullptr);
    for (size_t i = 0; i < std::size(kCrashSignals); ++i)
      sigaction(kCrashSignals[i], &g_replaced_actions[i], nullptr);
    sigaltstack(&g_replaced_stack, nullptr);
  }
  g_record_options = nullptr;
}

void CrashLog::RemoveOldRecords(const std::string& file) {
  // Ignores errors when it removes the file of an old crash record.  A file that does not exist
  // need not be removed.  If the file cannot be removed, writing the new crash record to it will
  // most likely fail too, and RecordFile::PrintWriteResult() reports that.
  std::error_code error;
  std::filesystem::remove(file, error);
}

}  // namespace openr_host
