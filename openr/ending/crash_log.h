// Writes a crash record when the crash of an object, which is a program of the robot, ends the
// run.  The crash record goes to standard error and to the file OPEN-R/EMON.LOG of a Memory Stick,
// where the emergency monitor of the real robot writes its crash record.
//
// On the real robot the crash of one object stops the whole robot.  So a crash ends the whole run
// here, with exit status 1.
#pragma once

#include <optional>
#include <string>
#include <vector>

namespace openr_host {

// While a CrashLog exists, a SIGSEGV, SIGBUS, SIGFPE or SIGILL that comes while an object runs ends
// the run with a crash record.  The same signals have their default action while no object runs.  A
// CrashLog does nothing under AddressSanitizer, because the report of AddressSanitizer says more
// about a crash.
class CrashLog {
 public:
  // `files` has the path of the file for crash records of each robot (RunStick::crash_log()); for
  // an empty path no file is written.  `adds` is true if other processes of the run write to the
  // same file: a crash record is then added at the end of the file, else it replaces the file.
  //
  // `place` is the text that follows the file's name in the report's finding, such as " on HOST";
  // it may be "".  Without a value, the finding does not name the file.  The finding must name the
  // file if the user cannot guess where the file is: it is on another host, or the user has named
  // no stick.
  explicit CrashLog(std::vector<std::string> files, bool adds = false,
                    const std::optional<std::string>& place = {});
  ~CrashLog();
  CrashLog(const CrashLog&) = delete;
  CrashLog& operator=(const CrashLog&) = delete;

  static bool exists();

  // Removes `file`, which may have the crash records of an earlier run.  Called at the beginning of
  // a run in which several processes add their crash records to this file.
  static void RemoveOldRecords(const std::string& file);
};

}  // namespace openr_host
