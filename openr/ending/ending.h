// Ends the process after a crash of an object, or when a handler of an object does not return.
//
// The process is ended in a signal handler.  docs/endings.md lists all functions that run in signal
// handlers.  Some of these functions make calls that are not allowed in signal handlers; the list
// says why this is safe.
#pragma once

#include <functional>

#include "openr/ending/signal_text.h"
#include "runtime/core/run_end.h"

namespace openr_host {

class Object;
struct EndGuardOptions;

// The reason why the process ends, as texts and data for the functions that report it.
struct Ending {
  EndKind kind = EndKind::kCrash;
  SignalText record;         // lines about the end of the process, for a person to read
  SignalText finding;        // a sentence about the end of the process, for the report of the run
  Object* object = nullptr;  // the object that was running; null if no object was running
  bool answered = false;     // true: an EndingAction has written the JSON answer; see EndingAnswer
};

RunEnd EndOf(const Ending& ending);

// Registers the function `action` for as long as the EndingAction exists.  Before CrashLog or
// Watchdog ends the process, all registered functions are called in the signal handler.  `action`
// may add to the texts of `ending`.
class EndingAction {
 public:
  explicit EndingAction(std::function<void(Ending* ending)> action);
  ~EndingAction();
  EndingAction(const EndingAction&) = delete;
  EndingAction& operator=(const EndingAction&) = delete;

 private:
  const std::function<void(Ending* ending)> action_;
  // The EndingAction that was registered before this one; it is called after this one.
  EndingAction* const outer_;

  friend void RunEndingActions(Ending* ending);
};

// Calls all functions that EndingActions have registered, the newest first.  Unregisters the
// functions before it calls them, so that a second call does not run them again.
void RunEndingActions(Ending* ending);

// While an EndingAnswer exists, the user of a run that ends early gets an answer that says why it
// has ended.  Only one EndingAnswer may exist at a time.  EndGuards (end_guards.h) makes it, and
// describes `options`.
class EndingAnswer {
 public:
  explicit EndingAnswer(const EndGuardOptions& options);
  ~EndingAnswer();
  EndingAnswer(const EndingAnswer&) = delete;
  EndingAnswer& operator=(const EndingAnswer&) = delete;
};

// The first of two steps by which a signal handler ends the process.  Writes out what objects have
// printed so far, and prepares for further signals that come while the process ends.
void BeginEnding(Ending* ending);
// Returns whether BeginEnding() was called in this process.
bool HasEndingBegun();
// The second of two steps by which a signal handler ends the process.  Calls the function
// EndGuardOptions::answer_first and the functions that EndingActions have registered, writes the
// JSON report of the run to the places that EndingAnswer knows, and does not return.
[[noreturn]] void FinishEnding();

}  // namespace openr_host
