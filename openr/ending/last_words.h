// What is still to be done when an object brings the process down: by a crash, or by a handler that
// does not return.
//
// It is done in a signal handler, on top of the object's handler.  Nothing of the program is in the
// middle of anything then, but for what the object had just called.  So most is done as
// always; should that fail, or hang, the process says the rest with what a signal handler may do.
#pragma once

#include <functional>
#include <string>

#include "openr/ending/signal_text.h"
#include "runtime/core/run_end.h"

namespace openr_host {

class Object;

// How the process comes to its end.
struct Ending {
  EndKind kind = EndKind::kCrash;
  SignalText record;         // for people, in lines
  SignalText finding;        // one sentence, for the report
  Object* object = nullptr;  // whose handler it is
  bool answered = false;     // the answer is given: see LastAnswer
};

RunEnd EndOf(const Ending& ending);

// While it lives: CrashLog and Watchdog call `say` before they end the process.
class LastWords {
 public:
  explicit LastWords(std::function<void(Ending* ending)> say);
  ~LastWords();
  LastWords(const LastWords&) = delete;
  LastWords& operator=(const LastWords&) = delete;

 private:
  const std::function<void(Ending* ending)> say_;
  LastWords* const outer_;  // says it afterwards

  friend void SayLastWords(Ending* ending);
};

// All of them, the newest first; once.
void SayLastWords(Ending* ending);

// While it lives: somebody waits for the end of a run.  The last line on standard error says what
// ended it.  When an answer in JSON is due and no LastWords has given it, {"error", "ended_by",
// "findings"} goes there.  One at a time.
class LastAnswer {
 public:
  // `descriptor`: -1 for none; `file`: "" for none.
  explicit LastAnswer(int descriptor, const std::string& file = "");
  ~LastAnswer();
  LastAnswer(const LastAnswer&) = delete;
  LastAnswer& operator=(const LastAnswer&) = delete;
};

// The end of the process, in two steps of a signal handler.  The first one prints what objects have
// printed so far; the second one says all last words and does not return.
void BeginEnding(Ending* ending);
[[noreturn]] void FinishEnding();

}  // namespace openr_host
