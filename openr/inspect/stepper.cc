#include "openr/inspect/stepper.h"

#include <fmt/format.h>
#include <signal.h>
#include <sys/mman.h>
#include <sys/prctl.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <charconv>
#include <cstdio>
#include <cstring>
#include <new>
#include <optional>
#include <sstream>
#include <system_error>
#include <utility>

#include "cli/print_plain.h"
#include "cli/process_copy.h"
#include "cli/progress_line.h"
#include "cli/prompt.h"
#include "cli/standard_streams.h"
#include "openr/decode/decode_message.h"
#include "openr/inspect/breakpoints.h"
#include "openr/inspect/shared_session.h"
#include "openr/inspect/step_commands.h"
#include "openr/inspect/step_printer.h"
#include "runtime/base/duration.h"
#include "runtime/base/spelling.h"
#include "runtime/core/system.h"

namespace openr_host {
namespace {

// Number of messages of a replay after which openr replay --step makes the next snapshot: a process
// that waits, so that the user can go back to this moment.
constexpr uint64_t kSnapshotMessages = 1000;

// Returns the number that `text` stands for; nullopt if `text` is no number, or if the number is
// too large.
std::optional<uint64_t> NumberIn(const std::string& text) {
  uint64_t number = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  if (error != std::errc() || end != text.data() + text.size()) return {};
  return number;
}

class Stepper {
 public:
  Stepper(Replayer* replayer, SharedSession* shared)
      : replayer_(replayer),
        view_(&replayer->simulation()),
        printer_(replayer, &view_),
        breaks_(replayer, &view_),
        shared_(shared),
        prompt_(&shared->history,
                [this](const std::vector<std::string>& words, const std::string& start) {
                  return WordsAfter(words, start);
                }) {
    breaks_.Load(shared_->breaks);
  }

  // Runs the session of openr replay --step.  Returns when the session is over.  Returns only in
  // the first process, because all copies of it end with _exit().
  void Run() {
    if (!Snapshot()) return;
    try {
      printer_.Show();
      for (std::string line; ReadLine(&line);) {
        if (!HandleCommand(line)) break;
      }
    } catch (const ReaderGone&) {
      shared_->NoteLostText(EPIPE);
    } catch (const std::system_error& error) {
      // Throws the error again if standard output works, because the reason of the error then is
      // not a failed write.
      if (std::ferror(stdout) == 0) throw;
      shared_->NoteLostText(error.code().value());
    }
    EndProcess();
  }

 private:
  // Keeps the state of the replay after the present message (takes a snapshot): forks; the copy
  // goes on with the user's commands, and the original process waits.  If the user goes back to
  // this snapshot, the original makes another copy.  Returns true in a copy, and false in the
  // original when openr replay --step is over.
  bool Snapshot() {
    const uint64_t here = replayer_->count();
    AddToSnapshots(here);
    for (;;) {
      shared_->FlushText();
      const pid_t copy = CopyProcess(Flushed::kNone, Orphan::kGoesOn);
      if (copy == 0) {
        BeginCopy(here);
        return true;
      }
      if (copy < 0) {
        EndSession(fmt::format("the process cannot be copied: {}", std::strerror(errno)));
        return false;
      }
      WaitForCopies();
      if (shared_->ends) return false;
      // Ends this process, which is a copy, if the user goes back to a moment before the state that
      // this process keeps.  The process of an earlier snapshot then makes a new copy.
      if (shared_->target < here && is_copy_) _exit(0);
    }
  }

  // Adds this process, which now keeps the state of the replay, to the list of snapshots.  Ends the
  // processes of snapshots that are no longer needed.  When such a process ends, its child becomes
  // a child of the process of the nearest earlier snapshot, which then waits for this child.  Each
  // process of a snapshot is a "subreaper" for this reason (prctl(2)).
  void AddToSnapshots(uint64_t here) {
    prctl(PR_SET_CHILD_SUBREAPER, 1);
    for (const pid_t process :
         shared_->snapshots.Add({here, replayer_->system().now_us(), getpid()}))
      kill(process, SIGKILL);
  }

  // Prepares this process to go on with the user's commands.  This process is a new copy (fork) of
  // the waiting process that keeps the state after `here` messages.
  void BeginCopy(uint64_t here) {
    is_copy_ = true;
    shared_->is_running = true;
    shared_->snapshots.RemoveAfter(here);
    last_snapshot_ = here;
    breaks_.Load(shared_->breaks);
    went_back_ = shared_->went_back;
    shared_->went_back = false;
    if (went_back_) CatchUp(here);
  }

  // Waits until no child process is left: the user then goes back to this snapshot or an earlier
  // one, or openr replay --step is over.  A child whose snapshot is no longer needed ends earlier;
  // its own child process then becomes a child of this process.
  void WaitForCopies() {
    WaitForAllCopies();
    if (shared_->is_running)
      EndSession("the replay has ended here, as the run did; start again to step up to it");
  }

  // Ends openr replay --step, because it cannot go on for the reason `why`.
  void EndSession(const std::string& why) {
    ClearProgressLine();
    PrintPlain("{}\n", why);
    shared_->FlushText();
    shared_->ends = shared_->differs = true;
    shared_->is_running = false;
  }

  // Runs this process to the message to which the user goes back.  This process is a new copy
  // (fork) of the waiting process that keeps the state after `here` messages.
  void CatchUp(uint64_t here) {
    went_back_ = false;  // Forward() must not stop at the snapshots that it takes now
    if (shared_->target > here) ForwardBy(shared_->target - here);
    if (shared_->until_us > 0) ForwardTo(shared_->until_us);
    went_back_ = true;
  }

  [[noreturn]] void EndProcess() {
    shared_->ends = true;
    shared_->is_running = false;
    shared_->differs = !replayer_->difference().empty();
    shared_->FlushText();
    _exit(0);
  }

  // Reads the user's next command.  Returns false at the end of the input.  Also returns false when
  // some text for standard output was lost, because nobody would read the answer.
  bool ReadLine(std::string* line) {
    if (!shared_->FlushText()) return false;
    return prompt_.Read(replayer_->count() == 0
                            ? "(start) "
                            : fmt::format("(message {}) ", replayer_->last().record.number),
                        line);
  }

  std::vector<std::string> WordsAfter(const std::vector<std::string>& words,
                                      const std::string& start) const;
  std::vector<std::string> QuantitiesFor(const std::string& start) const;

  // Runs forward by `count` messages, and takes snapshots (processes that wait) on the way.
  // Returns false if the replay ends earlier.  When the user later goes back to one of these
  // snapshots, this function returns once more, in the new copy of the process.  In the copy it
  // returns false, because the rest of the `count` messages must not follow.
  bool Forward(uint64_t count) {
    for (; count > 0; --count) {
      const uint64_t before = replayer_->count();
      while (replayer_->count() == before) {
        if (!replayer_->Step()) return false;
      }
      view_.Sample();
      if (replayer_->count() - last_snapshot_ >= kSnapshotMessages) {
        if (!Snapshot()) _exit(0);
        // Stops here in a new copy of the process, which was made because the user goes back.  This
        // copy comes from Snapshot() in the middle of an earlier command, and must not carry out
        // the rest of that command.
        if (went_back_) return false;
      }
    }
    return true;
  }

  // Runs forward by `count` messages, or to the end of the replay, and shows the progress on a
  // terminal.
  void ForwardBy(uint64_t count) {
    ProgressLine progress(STDERR_FILENO, count, "messages");
    for (uint64_t done = 0; done < count && Forward(1);) progress.Show(++done);
  }

  // Runs forward to the virtual time `time_us`, or to the end of the replay, and shows the progress
  // on a terminal.
  void ForwardTo(int64_t time_us) {
    RunProgressLine progress(STDERR_FILENO, replayer_->system().now_us(),
                             std::min(time_us, replayer_->length_us()));
    while (replayer_->NextTimeUs() <= time_us && Forward(1))
      progress.Show(replayer_->system().now_us());
  }

  [[noreturn]] void Back(uint64_t target, int64_t until_us = 0) {
    shared_->target = target;
    shared_->until_us = until_us;
    shared_->went_back = true;
    shared_->is_running = false;
    shared_->FlushText();
    _exit(0);
  }

  void Goto(std::string where) {
    if (where.starts_with("t=")) where.erase(0, 2);
    int64_t time_us = 0;
    if (const auto number = NumberIn(where)) {
      GotoMessage(*number);
    } else if (ParseDuration(where, &time_us).empty()) {
      if (time_us < replayer_->system().now_us())
        Back(shared_->snapshots.CountBefore(time_us), time_us);
      ForwardTo(time_us);
      printer_.Show();
    } else {
      PrintPlain("'{}' is neither a number of a message nor a time like 1.25s\n", where);
    }
  }

  void GotoMessage(uint64_t number) {
    const auto count = number == 0 ? std::optional<uint64_t>(0) : replayer_->CountUpTo(number);
    if (!count) {
      PrintPlain("the recording has no message {}\n", number);
      return;
    }
    if (*count < replayer_->count()) Back(*count);
    ForwardBy(*count - replayer_->count());
    printer_.Show();
  }

  // Runs forward to the next breakpoint, and shows on a terminal the progress towards the end of
  // the recording.  Returns the number of the breakpoint; 0 if the replay has ended before a
  // breakpoint.
  size_t ForwardToBreak() {
    RunProgressLine progress(STDERR_FILENO, replayer_->system().now_us(), replayer_->length_us());
    while (Forward(1)) {
      if (const size_t hit = breaks_.FindHit(); hit > 0) return hit;
      progress.Show(replayer_->system().now_us());
    }
    return 0;
  }

  void RunOn() {
    breaks_.Arm();
    if (const size_t hit = ForwardToBreak(); hit > 0)
      PrintPlain("break {}: {}\n", hit, breaks_.text(hit));
    printer_.Show();
  }

  void SaveBreaks() {
    const std::string text = breaks_.Save();
    std::memset(shared_->breaks, 0, sizeof shared_->breaks);
    std::memcpy(shared_->breaks, text.data(), std::min(text.size(), sizeof shared_->breaks - 1));
  }

  void Break(const std::string& text) {
    const std::string problem = breaks_.Add(text);
    PrintPlain("{}\n", problem.empty() ? fmt::format("break {}", breaks_.size()) : problem);
    SaveBreaks();
  }

  // Handles the commands that take a number: step, back and delete.  `command` is the first word of
  // the line, `rest` the text after it.  Returns false if `command` is another command.
  bool HandleNumberCommand(const std::string& command, const std::string& rest) {
    const bool steps = command == "step" || command == "s",
               backs = command == "back" || command == "b";
    if (!steps && !backs && command != "delete") return false;
    const auto number = rest.empty() ? std::optional<uint64_t>(1) : NumberIn(rest);
    if (!number) {
      PrintPlain("'{}' is no number\n", rest);
    } else if (steps) {
      ForwardBy(*number);
      printer_.Show();
    } else if (backs) {
      Back(replayer_->count() - std::min(*number, replayer_->count()));
    } else {
      if (!breaks_.Remove(*number)) PrintPlain("there is no break {}\n", *number);
      SaveBreaks();
    }
    return true;
  }

  // Handles the command `line` of openr replay --step.  Returns false if the command is "quit".
  bool HandleCommand(const std::string& line) {
    went_back_ = false;
    std::istringstream words(line);
    std::string command, rest;
    words >> command;
    std::getline(words >> std::ws, rest);
    rest.erase(rest.find_last_not_of(" \t\r") + 1);
    if (HandleNumberCommand(command, rest)) return true;
    if (command == "goto" || command == "g") {
      Goto(rest);
    } else if (command == "run" || command == "r") {
      RunOn();
    } else if (command == "break") {
      Break(rest);
    } else if (command == "breaks") {
      for (size_t i = 1; i <= breaks_.size(); ++i) PrintPlain("{}: {}\n", i, breaks_.text(i));
    } else if (command == "print" || command == "p") {
      printer_.Print(rest);
    } else if (command == "quit" || command == "q") {
      return false;
    } else if (command == "help" || command == "h") {
      PrintPlain("{}", kStepHelp);
    } else if (!command.empty()) {
      PrintPlain("no command '{}'{}; 'help' tells the commands\n", command,
                 DidYouMean(command, kStepCommands));
    }
    return true;
  }

  Replayer* const replayer_;
  SimulationView view_;
  StepPrinter printer_;
  Breakpoints breaks_;
  SharedSession* const shared_;
  Prompt prompt_;
  bool is_copy_ = false;
  bool went_back_ = false;
  uint64_t last_snapshot_ = 0;
};

// Returns the names of quantities from which the Tab key completes `start`, the word that the user
// is typing.  Leaves out the long names of robot 0, "robots[0]. ...", unless the user has begun to
// type "robots", because each of these quantities has a short name, too.
std::vector<std::string> Stepper::QuantitiesFor(const std::string& start) const {
  std::vector<std::string> names = QuantitiesOf(view_.run());
  if (start.starts_with("rob")) {
    for (std::string& name : LongNamesOf(view_.run())) names.push_back(std::move(name));
  }
  return names;
}

// Returns the words that may follow `words` in a command of openr replay --step.  From these words
// the Tab key completes `start`, the word that the user is typing.
std::vector<std::string> Stepper::WordsAfter(const std::vector<std::string>& words,
                                             const std::string& start) const {
  if (words.empty()) return kStepCommands;
  const std::string& command = words[0];
  const bool is_break = command == "break" && words.size() > 1;
  std::vector<std::string> names;
  if (command == "break" && words.size() == 1)
    return {"object", "service", "state", "finding", "when"};
  if (is_break && words.size() == 2 && (words[1] == "object" || words[1] == "state")) {
    for (const auto& object : replayer_->system().objects()) names.push_back(object->name);
  } else if (is_break && words.size() == 2 && words[1] == "service") {
    for (int i = 0; i < replayer_->system().robot_count(); ++i) {
      for (const auto& [service, entry] : replayer_->system().robot(i).directory) {
        names.push_back(service);
        names.push_back(TypeOfService(service));
      }
    }
  } else if (is_break && words.size() == 2 && words[1] == "when") {
    names = QuantitiesFor(start);
  } else if ((command == "print" || command == "p") && words.size() == 1) {
    names = QuantitiesFor(start);
    for (const char* const what :
         {"queue", "waiting", "objects", "joints", "findings", "hash", "message"})
      names.push_back(what);
  }
  return names;
}

}  // namespace

bool StepThrough(const ReplayOptions& options) {
  void* const memory = mmap(nullptr, sizeof(SharedSession), PROT_READ | PROT_WRITE,
                            MAP_SHARED | MAP_ANONYMOUS, -1, 0);
  if (memory == MAP_FAILED) throw std::bad_alloc();
  SharedSession* const shared = new (memory) SharedSession{};
  Replayer replayer(options);
  Stepper(&replayer, shared).Run();
  const bool good = !shared->differs;
  if (shared->is_text_lost) NoteLostAnswer(shared->lost_errno);
  munmap(memory, sizeof(SharedSession));
  return good;
}

}  // namespace openr_host
