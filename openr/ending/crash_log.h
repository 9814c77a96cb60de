// The record of a crash that ended a run: EMON.LOG, on a stick in OPEN-R/ as the robot's emergency
// monitor leaves it, and the same on standard error.
//
// On the robot a crash of one object is a crash of the robot; here it ends the run with exit
// status 1.
#pragma once

#include <optional>
#include <string>
#include <vector>

namespace openr_host {

// While it lives, SIGSEGV, SIGBUS, SIGFPE and SIGILL of an object end the run with a record.
// Those of the program itself end it the way the system does.  Under AddressSanitizer nothing is
// done: its own report says more.
class CrashLog {
 public:
  // `files`: by robot (RunStick::crash_log()); an empty name is no file.  `adds`: records that are
  // there already, of other processes of the run, stay.  `place`: set when the file lies on no
  // stick that the person has named.  The finding then names the file, with this text behind it
  // (" on HOST").
  explicit CrashLog(std::vector<std::string> files, bool adds = false,
                    const std::optional<std::string>& place = {});
  ~CrashLog();
  CrashLog(const CrashLog&) = delete;
  CrashLog& operator=(const CrashLog&) = delete;

  // Before the processes of a run that add theirs: the record in this file is of another run.
  static void BeginAfresh(const std::string& file);
};

}  // namespace openr_host
