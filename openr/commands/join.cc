#include <errno.h>
#include <fcntl.h>
#include <fmt/format.h>
#include <limits.h>
#include <signal.h>
#include <string.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <filesystem>
#include <memory>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "cli/exit_code.h"
#include "cli/print_plain.h"
#include "cli/process_copy.h"
#include "distribution/process_slot.h"
#include "distribution/worker.h"
#include "openr/commands/commands.h"
#include "openr/commands/common_flags.h"
#include "openr/commands/distribution_flags.h"
#include "openr/ending/end_guards.h"
#include "openr/run/report.h"
#include "openr/simulation/run_stick.h"
#include "openr/simulation/sanitizer_start.h"

namespace openr_host {
namespace {

struct JoinFlags {
  WorkerOptions worker;
  bool restarts = false;
  int64_t wait_us = 60'000'000;
  int64_t handler_limit_us = 10'000'000;
  pid_t parent = 0;       // process id of the run that has started this worker; 0: none
  std::string crash_log;  // file for the crash records of a worker that a run has started
};

std::string JoinedStickProblem(const std::string& folder) {
  if (std::filesystem::is_directory(folder)) return "";
  return fmt::format("{}: there is no such folder; give a copy of the run's stick", folder);
}

// Exit codes of a child process that runs a worker for --restart.
constexpr int kRefused = 3;         // the run refuses this version or stick; a restart cannot help
constexpr int kOffline = 4;         // the worker threw an exception, usually for lack of a network
constexpr int kNeedsSanitizer = 5;  // the run's objects need the library of AddressSanitizer

// Makes this worker process end when its parent process `parent` ends, even by a crash.  The parent
// is the run that has started the worker.  Ignores Ctrl-C and the closing of the terminal, because
// the parent handles both.
void BecomeChild(pid_t parent) {
  prctl(PR_SET_PDEATHSIG, SIGKILL);
  if (kill(parent, 0) != 0) _exit(kExitWrong);  // the run `parent` has ended already
  ::signal(SIGINT, SIG_IGN);
  ::signal(SIGHUP, SIG_IGN);
}

// The first signal that asked this process to end: SIGINT, SIGTERM or SIGHUP; 0: none.
volatile sig_atomic_t g_ended_by = 0;
volatile sig_atomic_t g_child = 0;  // process id of the worker that --restart runs; 0: none

// Handles SIGINT, SIGTERM and SIGHUP.  After the first signal, a worker finishes the handler that
// runs, tells the run that it leaves, and ends.  With --restart, this process is the parent of the
// worker: it sends SIGTERM to the worker at the first signal, and kills the worker at the second
// signal.
void OnEndSignal(int signal) {
  const int child = g_child;
  if (child > 0) kill(child, g_ended_by == 0 ? SIGTERM : SIGKILL);
  if (g_ended_by == 0) g_ended_by = signal;
}

// Installs OnEndSignal() as the handler of SIGINT, SIGTERM and SIGHUP, with the additional `flags`
// of sigaction().  A signal that this process was started to ignore, for example by nohup, stays
// ignored.
void HandleEndSignals(int flags) {
  for (const int signal : {SIGINT, SIGTERM, SIGHUP}) {
    struct sigaction action {};
    sigaction(signal, nullptr, &action);
    if (action.sa_handler == SIG_IGN) continue;
    action.sa_handler = &OnEndSignal;
    // Runs the signal handler on the alternate stack, because an object may have used up its own
    // stack.
    action.sa_flags = SA_ONSTACK | flags;
    sigemptyset(&action.sa_mask);
    sigaction(signal, &action, nullptr);
  }
}

// Ends the process by the signal that it has caught, so that its parent process sees the signal and
// not an exit code.
[[noreturn]] void EndBySignal() {
  ::signal(g_ended_by, SIG_DFL);
  raise(g_ended_by);
  _exit(128 + g_ended_by);
}

// Discards all output to standard error while an object of this class exists, if `is_on` is true.
// Used when a worker has found no network and another worker tries again, because Cyclone DDS would
// print the same errors at each attempt.
class SilencedErrors {
 public:
  explicit SilencedErrors(bool is_on) : before_(is_on ? dup(STDERR_FILENO) : -1) {
    const int nowhere = is_on ? open("/dev/null", O_WRONLY | O_CLOEXEC) : -1;
    if (nowhere < 0) return;
    dup2(nowhere, STDERR_FILENO);
    close(nowhere);
  }
  ~SilencedErrors() {
    if (before_ < 0) return;
    dup2(before_, STDERR_FILENO);
    close(before_);
  }
  SilencedErrors(const SilencedErrors&) = delete;
  SilencedErrors& operator=(const SilencedErrors&) = delete;

 private:
  const int before_;
};

struct Outcome {
  std::string problem;
  bool is_refused = false;
};

// Runs a worker until the run or the user ends it.  When Work() returns, the worker has told the
// run that it leaves.  Throws an exception if the worker cannot be made, usually because there is
// no network.  If `is_known`, discards the errors that DDS prints while the worker is made, because
// an earlier worker, which could not be made either, has printed these errors already.
Outcome Work(const WorkerOptions& options, bool is_known) {
  std::optional<Worker> worker;
  {
    const SilencedErrors silenced(is_known);
    worker.emplace(options);
  }
  const EndingAction ending_action([&worker](Ending* ending) {
    if (ending->object == nullptr) return;
    const CurrentScope scope(ending->object->system, ending->object);
    worker->ReportCrash(ending->finding.text());
    // Prints the message whose handler has ended the process.  Does so only after ReportCrash(), so
    // that the run gets the report even if PrintHandledMessage() crashes.
    PrintHandledMessage(*ending);
  });
  const std::string problem = worker->Run();
  return {problem, worker->is_refused()};
}

// Copies the default Memory Stick of this host to a temporary folder, because objects may change
// files on it.  Returns the folder; "" when the copy cannot be made.  The worker uses this folder
// if the run is on another host and the run's stick has the same files.  Stores in `*stick` a
// RunStick; its destructor removes the folder.
std::string OwnStick(std::optional<RunStick>* stick) {
  try {
    return stick->emplace("", true).folder();
  } catch (const std::exception&) {
    return "";
  }
}

// The worker that `openr join` runs in this process.  The constructor takes the flags of the
// command, and Run() returns the exit code.
class JoinedWorker {
 public:
  explicit JoinedWorker(JoinFlags flags);
  JoinedWorker(const JoinedWorker&) = delete;
  JoinedWorker& operator=(const JoinedWorker&) = delete;

  // Runs the worker until the run or the user ends it.  Returns the exit code.  If `is_known`,
  // discards the errors that DDS prints while the worker is made (Work()).  If the objects need the
  // library of AddressSanitizer and this process lacks the library, sets `*sanitized_stick` to the
  // path of their stick and returns kNeedsSanitizer.  If `sanitized_stick` is null, starts this
  // program again instead, with the library.
  int Run(bool is_known = false, std::string* sanitized_stick = nullptr);

 private:
  // Returns true if a run has started this worker, and false if a user has started it.
  bool is_child() const { return flags_.parent != 0; }
  std::string StickProblem(const std::string& stick);
  void Begin(const std::string& stick);

  JoinFlags flags_;
  std::optional<EndGuards> guards_;
  // Stick whose images need the library of AddressSanitizer, which this process lacks; "": none.
  std::string found_stick_;
  std::optional<RunStick> own_stick_;
};

JoinedWorker::JoinedWorker(JoinFlags flags) : flags_(std::move(flags)) {
  WorkerOptions& worker = flags_.worker;
  if (is_child()) {
    BecomeChild(flags_.parent);
  } else {
    HandleEndSignals(static_cast<int>(SA_RESETHAND));
    worker.is_end_requested = [] { return g_ended_by != 0; };
    worker.find_stick_problem = [this](const std::string& stick) { return StickProblem(stick); };
    worker.own_stick = [this] { return OwnStick(&own_stick_); };
  }
  worker.master_wait_ms = flags_.wait_us / 1000;
  worker.say = [name = worker.process](const std::string& line) {
    PrintPlain(stderr, "openr: process '{}': {}\n", name, line);
  };
  worker.before_loading = [this](const std::string& stick) { Begin(stick); };
}

int JoinedWorker::Run(bool is_known, std::string* sanitized_stick) {
  const Outcome outcome = Work(flags_.worker, is_known);
  if (outcome.problem.empty()) return kExitGood;
  if (g_ended_by != 0) EndBySignal();
  if (!found_stick_.empty()) {
    own_stick_.reset();
    if (sanitized_stick != nullptr) {
      *sanitized_stick = found_stick_;
      return kNeedsSanitizer;
    }
    StartWithSanitizerOf(found_stick_);  // returns only if openr could not be started again
  }
  flags_.worker.say(outcome.problem);
  return outcome.is_refused ? kRefused : kExitWrong;
}

// Returns the reason why this process cannot run the objects of `stick`; "" if it can.
std::string JoinedWorker::StickProblem(const std::string& stick) {
  if (MissingSanitizer(stick).empty()) return "";
  found_stick_ = stick;
  return fmt::format(
      "{}: its objects were built with --sanitize, so the process starts again "
      "with the library of AddressSanitizer",
      stick);
}

// Prepares this process for errors of the objects of `stick`: it writes a crash record if an object
// crashes, and ends if a handler does not return.
void JoinedWorker::Begin(const std::string& stick) {
  const bool is_own = own_stick_ && own_stick_->folder() == stick;
  const std::string file = is_child() ? flags_.crash_log
                           : is_own   ? own_stick_->crash_log()
                                      : CrashLogOn(stick);
  EndGuardOptions options;
  options.prints_end = false;  // false, because the run does not end with this process
  options.crash_logs = {file};
  options.adds_to_crash_logs = true;
  // Names no place if the crash record is on the run's stick.
  if (!is_child()) {
    options.crash_log_place = " on " + HostName();
  } else if (file != CrashLogOn(stick)) {
    options.crash_log_place = "";
  }
  options.handler_limit_us = flags_.handler_limit_us;
  guards_.emplace(std::move(options));
}

// Runs a worker in this process, which is a child process of `openr join --restart`.  Returns the
// exit code, which is kOffline if the worker throws an exception.  With `is_known`, does not print
// the error of this exception, because an earlier worker has printed the same error.  If the exit
// code is kNeedsSanitizer, writes to the pipe `stick_pipe` the path of the stick whose images need
// the library of AddressSanitizer.
int JoinInThisProcess(const JoinFlags& flags, bool is_known, int stick_pipe) {
  try {
    std::string stick;
    const int code = JoinedWorker(flags).Run(is_known, &stick);
    if (code == kNeedsSanitizer &&
        write(stick_pipe, stick.data(), stick.size()) != static_cast<ssize_t>(stick.size()))
      return kExitWrong;
    return code;
  } catch (const std::exception& error) {
    if (!is_known) PrintPlain(stderr, "openr: {}\n", error.what());
    return kOffline;
  }
}

// Runs JoinInThisProcess() in a child process and waits until the child process ends.  Returns the
// status that waitpid() gives.  Sets `*child` to the child's process id, which the caller prints,
// and `stick` to the path that the child has written to its pipe.
int JoinInChild(const JoinFlags& flags, bool is_known, pid_t* child, std::string* stick) {
  int ends[2];
  if (pipe2(ends, O_CLOEXEC) != 0)
    throw std::runtime_error(fmt::format("pipe: {}", strerror(errno)));
  *child = CopyProcess(Flushed::kNone, Orphan::kIsKilled);
  if (*child < 0) throw std::runtime_error(fmt::format("fork: {}", strerror(errno)));
  // Calls exit() and not EndCopy(), because this copy of the process is a whole worker and has to
  // run its exit handlers.
  if (*child == 0) exit(JoinInThisProcess(flags, is_known, ends[1]));
  close(ends[1]);
  g_child = *child;
  // Passes on a signal that came before g_child was set, because it has not reached the child.
  if (g_ended_by != 0) kill(*child, SIGTERM);
  const int status = WaitForEnd(*child);
  g_child = 0;
  // The child can write the path of the stick's folder before this process reads the path, because
  // a pipe has room for PATH_MAX bytes.
  char path[PATH_MAX];
  const ssize_t size = read(ends[0], path, sizeof path);
  stick->assign(path, static_cast<size_t>(std::max<ssize_t>(size, 0)));
  close(ends[0]);
  return status;
}

// Runs a worker in a child process, and starts another worker when this worker ends before the run
// is over.  Each worker has a new process, so a crash does not harm the next worker.  When a worker
// finds no network, prints an error once and starts the next worker.  But when the first worker
// finds no network, returns kExitWrong, because the flags for the network are probably wrong.
int JoinWithRestarts(const JoinFlags& flags) {
  constexpr unsigned kPause_s = 1;
  HandleEndSignals(0);
  bool is_offline = false;
  for (bool is_first = true;; is_first = false) {
    pid_t child = 0;
    std::string stick;
    const int status = JoinInChild(flags, is_offline, &child, &stick);
    const int code = ExitCodeOf(status);
    if (code == kExitGood) return kExitGood;
    // Starts this process, and not only a child, again with the library of AddressSanitizer,
    // because all later workers are copies of this process.
    if (code == kNeedsSanitizer) StartWithSanitizerOf(stick);
    if (code == kRefused || (code == kOffline && is_first)) return kExitWrong;
    if (g_ended_by != 0) EndBySignal();
    if (code != kOffline) {
      PrintPlain(stderr, "openr: process '{}' (pid {}) has ended; another one comes\n",
                 flags.worker.process, child);
    } else if (!is_offline) {
      PrintPlain(stderr, "openr: process '{}': tries again until it can\n", flags.worker.process);
    }
    is_offline = code == kOffline;
    sleep(kPause_s);
    if (g_ended_by != 0) EndBySignal();
  }
}

}  // namespace

void AddJoinCommand(CLI::App* app, int* exit_code) {
  CLI::App* const command = app->add_subcommand(
      "join", "Runs the objects that a run has placed in a process of another name or host");
  auto flags = std::make_shared<JoinFlags>();
  flags->worker.bus.run = "openr";
  command->add_option("--process", flags->worker.process, "Its name in the placement")
      ->required()
      ->check(IsNameOf("process"));
  command->add_option("--run-name", flags->worker.bus.run, "Name of the run")
      ->check(IsNameOf("run"))
      ->capture_default_str();
  command
      ->add_option("--stick", flags->worker.stick,
                   "A copy of the run's stick (default: the folder that the run names)")
      ->check(CLI::Validator(JoinedStickProblem, ""));
  AddDurationFlag(command, "--wait", &flags->wait_us, "How long to wait for the run");
  AddDurationFlag(command, "--handler-limit", &flags->handler_limit_us,
                  "End the process when a handler uses more processor time; 0s: never");
  command->add_flag("--restart", flags->restarts,
                    "Come again, with objects as at the beginning, when it ends before the run is "
                    "over: by a crash, or because the run cannot be reached");
  // Hides --child-of, --crash-log and --session from the help, because only openr run gives these
  // flags, and no user does.
  command->add_option("--child-of", flags->parent)->group("");
  command->add_option("--crash-log", flags->crash_log)->group("");
  command->add_option("--session", flags->worker.session)->group("");
  AddBusFlags(command, &flags->worker.bus);
  command->callback([flags, exit_code] {
    if (!flags->worker.stick.empty()) StartWithSanitizerOf(flags->worker.stick);
    flags->worker.waits_for_predecessor = flags->restarts;
    const int code = flags->restarts ? JoinWithRestarts(*flags) : JoinedWorker(*flags).Run();
    *exit_code = code == kRefused && !flags->restarts ? kExitWrong : code;
  });
}

}  // namespace openr_host
