// Writes the record of a crash that ends a run: to EMON.LOG in OPEN-R/ of a stick, where the
// robot's emergency monitor writes it, and to standard error.
//
// On the robot a crash of one object is a crash of the robot.  Here it ends the run with exit
// status 1.
#pragma once

#include <optional>
#include <string>
#include <vector>

namespace openr_host {

// While a CrashLog exists, SIGSEGV, SIGBUS, SIGFPE and SIGILL of an object end the run with a
// record.  The same signals of the program itself have their default action.  Does nothing under
// AddressSanitizer, whose own report says more.
class CrashLog {
 public:
  // `files` are the record files by robot (RunStick::crash_log()); an empty name: no file.  With
  // `adds`, records in a file stay, because other processes of the run write there too.  `place` is
  // set if the file is on no stick that the user has named: then the finding names the file,
  // followed by this text (" on HOST").
  explicit CrashLog(std::vector<std::string> files, bool adds = false,
                    const std::optional<std::string>& place = {});
  ~CrashLog();
  CrashLog(const CrashLog&) = delete;
  CrashLog& operator=(const CrashLog&) = delete;

  // Removes the record of an earlier run.  Called before processes of a run add their records to
  // the file.
  static void BeginAfresh(const std::string& file);
};

}  // namespace openr_host
