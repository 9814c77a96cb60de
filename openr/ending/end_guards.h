// EndGuards: reports the early end of a run.
//
// The code of an object ends the process of a run at once if it crashes or if a handler does not
// return.  A constructor of a global object, which runs while the image is loaded, can do the same,
// and also by abort() or exit().  Each command that loads images makes its EndGuards before it
// loads them, so that all these errors are reported in the same way.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "openr/ending/crash_log.h"
#include "openr/ending/ending.h"
#include "openr/ending/watchdog.h"

namespace openr_host {

struct EndGuardOptions {
  // Whether the last line on standard error says why the run has ended.
  bool prints_end = true;
  // The descriptor (-1: none) and the file ("": none) to which the JSON object {"error",
  // "ended_by", "findings"} is written, unless an EndingAction has already written an answer.
  int answer = -1;
  std::string answer_file = "";
  // A function that is called before the EndingActions, in the signal handler, to answer a program
  // that waits; may be empty.  The program gets this answer even if an EndingAction crashes.
  std::function<void(Ending* ending)> answer_first = nullptr;

  // The path of the file for crash records of each robot (RunStick::crash_log()); for a robot
  // without a path, or with an empty one, no file is written.
  std::vector<std::string> crash_logs = {};
  // True if other processes of the run write to the same file: a crash record is then added at the
  // end of the file, else it replaces the file.
  bool adds_to_crash_logs = false;
  // The text that follows the file's name in the report's finding, such as " on HOST"; it may be
  // "".  Without a value, the finding does not name the file.  The finding must name the file if
  // the user cannot guess where the file is: it is on another host, or the user has named no stick.
  std::optional<std::string> crash_log_place = {};

  // The processor time that a handler, or the loading of an image, may use; 0: no limit.
  int64_t handler_limit_us = 10'000'000;
  // The name by which the user sets this limit, for the message; "": the user cannot set it.
  const char* limit_name = "--handler-limit";
};

// While an EndGuards exists, an early end of the run is reported as the options say, and the
// process ends with status 1.  Only one EndGuards may exist at a time.
class EndGuards {
 public:
  explicit EndGuards(EndGuardOptions options) : options_(std::move(options)) {}
  EndGuards(const EndGuards&) = delete;
  EndGuards& operator=(const EndGuards&) = delete;

  // Goes on in a fork of the process, which has no timers.
  void StartAgain() { watchdog_.StartAgain(); }
  // Writes crash records to other files from now on (EndGuardOptions::crash_logs).
  void set_crash_logs(std::vector<std::string> files) { options_.crash_logs = std::move(files); }

 private:
  EndGuardOptions options_;  // before the members that refer to it
  const EndingAnswer answer_{options_};
  const CrashLog crash_log_{options_};
  Watchdog watchdog_{options_.handler_limit_us, options_.limit_name};
};

}  // namespace openr_host
