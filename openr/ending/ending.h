// Ends the process after a crash of an object, or after a handler that does not return.
//
// All of this runs in a signal handler.  docs/endings.md names every function that does, and says
// which of them call what a signal handler may not call, and why that is safe here.
#pragma once

#include <functional>
#include <string>

#include "openr/ending/signal_text.h"
#include "runtime/core/run_end.h"

namespace openr_host {

class Object;

// The facts about the end of the process, as texts and data for those that report it.
struct Ending {
  EndKind kind = EndKind::kCrash;
  SignalText record;         // lines for a person to read
  SignalText finding;        // one sentence for the report
  Object* object = nullptr;  // the object that ran; null if none did
  bool answered = false;     // an EndingAction has written the answer; see EndingAnswer
};

RunEnd EndOf(const Ending& ending);

// Registers the function `action` while the EndingAction exists.  CrashLog and Watchdog call the
// function, in a signal handler, before they end the process.  `action` may add to the ending's
// texts.
class EndingAction {
 public:
  explicit EndingAction(std::function<void(Ending* ending)> action);
  ~EndingAction();
  EndingAction(const EndingAction&) = delete;
  EndingAction& operator=(const EndingAction&) = delete;

 private:
  const std::function<void(Ending* ending)> action_;
  EndingAction* const outer_;  // registered before this one, and called after it

  friend void RunEndingActions(Ending* ending);
};

// Calls all registered functions, the newest first.  A second call does nothing.
void RunEndingActions(Ending* ending);

// While an EndingAnswer exists, a run that ends early says on the last line of standard error what
// ended it.  If an answer in JSON is due and no EndingAction has written the answer, {"error",
// "ended_by", "findings"} is written.  Only one may exist at a time.
class EndingAnswer {
 public:
  // The answer goes to `descriptor` (-1: none) and to `file` ("": none).
  explicit EndingAnswer(int descriptor, const std::string& file = "");
  ~EndingAnswer();
  EndingAnswer(const EndingAnswer&) = delete;
  EndingAnswer& operator=(const EndingAnswer&) = delete;
};

// The two functions end the process, as two steps of a signal handler.  BeginEnding() writes out
// what objects have printed so far, and prepares for signals that come while the process ends.
// FinishEnding() runs the registered actions, writes the answer, and does not return.
void BeginEnding(Ending* ending);
[[noreturn]] void FinishEnding();

}  // namespace openr_host
