#include "openr/ending/ending.h"

#include <pthread.h>
#include <signal.h>
#include <unistd.h>

#include <optional>
#include <string>
#include <utility>

#include "cli/console.h"
#include "cli/exit_code.h"
#include "cli/prepared_file.h"
#include "openr/ending/end_guards.h"
#include "runtime/base/assert.h"
#include "runtime/core/current.h"
#include "runtime/core/object.h"

namespace openr_host {
namespace {

// Time limit for all EndingActions together (functions that are called before the process ends),
// after which the remaining actions are left out.  Actions normally take some milliseconds.
constexpr unsigned kActionsMaxS = 10;

// Signals that are handled while EndingActions (functions that are called before the process ends)
// run: SIGALRM shows that the actions took too long, the others show that an action has crashed.
constexpr int kHandledSignals[] = {SIGSEGV, SIGBUS, SIGFPE, SIGILL, SIGTRAP, SIGABRT, SIGALRM};

EndingAction* g_newest = nullptr;
Ending* g_ending = nullptr;
volatile sig_atomic_t g_has_begun = 0;  // 1: the end of the process has begun
Current g_current;  // the object and handler that ran when the end of the process began
// The options of the EndingAnswer; null while no EndingAnswer exists.
const EndGuardOptions* g_options = nullptr;
// The file EndGuardOptions::answer_file; no value: no file.  The EndingAnswer works out the paths
// for this file in advance, because OnSignalDuringEnding() must not allocate memory.
std::optional<PreparedFile> g_answer_file;

void AnswerInSignal(const Ending& ending) {
  if (g_options == nullptr) return;
  if (g_options->prints_end) {
    SignalText last;
    last.Add("ended by ").Add(EndName(ending.kind)).Add(": ");
    if (ending.object != nullptr) last.Add(ending.object->name.c_str()).Add(": ");
    last.Add(ending.finding.text());
    last.Add("\n").WriteTo(STDERR_FILENO);
  }
  if (ending.answered) return;
  const char* const ended_by = EndName(ending.kind);
  WriteEndingAsJson(ending.record, ending.finding, ended_by, g_current, g_options->answer);
  if (!g_answer_file) return;
  const int file = g_answer_file->Open();
  if (file < 0) return;
  WriteEndingAsJson(ending.record, ending.finding, ended_by, g_current, file);
  g_answer_file->Close();
}

// Handles a signal that comes while EndingActions (functions that are called before the process
// ends) run, because an action has crashed or the actions took too long.  Does not run the
// remaining actions: writes the JSON report of the run, if it is not written yet, and ends the
// process.
void OnSignalDuringEnding(int) {
  const Ending* const ending = std::exchange(g_ending, nullptr);
  if (ending != nullptr) AnswerInSignal(*ending);
  _exit(kExitWrong);
}

}  // namespace

RunEnd EndOf(const Ending& ending) {
  const std::string object = ending.object == nullptr ? "" : ending.object->name + ": ";
  return {ending.kind, object + std::string(ending.finding.text())};
}

EndingAction::EndingAction(std::function<void(Ending*)> action)
    : action_(std::move(action)), outer_(std::exchange(g_newest, this)) {}

EndingAction::~EndingAction() { g_newest = outer_; }

void RunEndingActions(Ending* ending) {
  // Takes the list of EndingActions out of g_newest first, so that no action is called twice if an
  // action itself ends the process.
  for (EndingAction* each = std::exchange(g_newest, nullptr); each != nullptr; each = each->outer_)
    each->action_(ending);
}

EndingAnswer::EndingAnswer(const EndGuardOptions& options) {
  ASSERT(g_options == nullptr);  // only one EndingAnswer may exist at a time
  g_options = &options;
  // Calls pthread_sigmask() once without an effect, because its first call looks the C library's
  // function up (refused_hooks.cc), which is not allowed in a signal handler.
  pthread_sigmask(SIG_BLOCK, nullptr, nullptr);
  if (!options.answer_file.empty()) g_answer_file.emplace(options.answer_file);
}

EndingAnswer::~EndingAnswer() {
  g_options = nullptr;
  g_answer_file.reset();
}

bool HasEndingBegun() { return g_has_begun != 0; }

void BeginEnding(Ending* ending) {
  g_has_begun = 1;
  g_ending = ending;
  // From now on no object is the current one, so functions for memory and files are those of the
  // host.
  g_current = std::exchange(t_current, {});
  ending->object = g_current.object;
  struct sigaction action {};
  action.sa_handler = &OnSignalDuringEnding;
  action.sa_flags = SA_ONSTACK;
  sigset_t signals;
  sigemptyset(&signals);
  for (const int signal : kHandledSignals) {
    sigaction(signal, &action, nullptr);
    sigaddset(&signals, signal);
  }
  // Unblocks the signals, because the signal whose handler is running is blocked: the kernel would
  // end the process at once if that signal came a second time.
  pthread_sigmask(SIG_UNBLOCK, &signals, nullptr);
  alarm(kActionsMaxS);
  EndConsoleLine();
}

void FinishEnding() {
  Ending* const ending = g_ending;
  if (g_options != nullptr && g_options->answer_first) g_options->answer_first(ending);
  RunEndingActions(ending);
  AnswerInSignal(*ending);
  _exit(kExitWrong);
}

}  // namespace openr_host
