// Writes a crash record when the crash of an object, which is a program of the robot, ends the
// run.  The crash record goes to standard error and to the file OPEN-R/EMON.LOG of a Memory Stick,
// where the emergency monitor of the real robot writes its crash record.
//
// On the real robot the crash of one object stops the whole robot.  So a crash ends the whole run
// here, with exit status 1.
#pragma once

#include <string>

namespace openr_host {

struct EndGuardOptions;

// While a CrashLog exists, a SIGSEGV, SIGBUS, SIGFPE, SIGILL or SIGABRT that comes while an object
// runs ends the run with a crash record.  The same signals have their default action while no
// object runs.  A CrashLog does nothing under AddressSanitizer, because the report of
// AddressSanitizer says more about a crash.  EndGuards (end_guards.h) makes it, and describes
// `options`.
class CrashLog {
 public:
  explicit CrashLog(const EndGuardOptions& options);
  ~CrashLog();
  CrashLog(const CrashLog&) = delete;
  CrashLog& operator=(const CrashLog&) = delete;

  // Removes `file`, which may have the crash records of an earlier run.  Called at the beginning of
  // a run in which several processes add their crash records to this file.
  static void RemoveOldRecords(const std::string& file);
};

}  // namespace openr_host
