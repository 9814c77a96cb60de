// What is left of a run that an object brought down: OPEN-R/EMON.LOG on its stick, as the
// robot's emergency monitor leaves it, and the same on standard error.
//
// On the robot a crash of one object is a crash of the robot; here it ends the run with exit
// status 1.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace openr_host {

// While it lives, SIGSEGV, SIGBUS, SIGFPE and SIGILL of an object end the run with a record.
// Those of the program itself end it the way the system does.  Under AddressSanitizer nothing is
// done: its own report says more.
class CrashLog {
 public:
  // `sticks`: folders that hold OPEN-R/, by robot; empty ones get no file.  `adds`: records that
  // are there already, of other processes of the run, stay.  `host`: of this process, whose stick
  // others do not see; the finding says where the record is.
  explicit CrashLog(const std::vector<std::string>& sticks, bool adds = false,
                    const std::string& host = "");
  ~CrashLog();
  CrashLog(const CrashLog&) = delete;
  CrashLog& operator=(const CrashLog&) = delete;

  // Before the processes of a run that add theirs: the record on this stick is of another run.
  static void BeginAfresh(const std::string& stick);
};

}  // namespace openr_host
