#include "distribution/liveness_check.h"

#include <errno.h>
#include <fmt/format.h>
#include <signal.h>

#include <algorithm>
#include <filesystem>
#include <limits>
#include <sstream>

#include "runtime/base/read_file.h"

namespace openr_host {
namespace {

struct ProcessStat {
  // State of the process as one letter (see proc(5)); "" if there is no such process, or if this
  // user may not see the process in /proc.
  std::string state;
  std::string start_time;
};

// Reads /proc/PID/stat.  The search for fields begins after the last ')', because the name of the
// program is in parentheses and may itself contain spaces and parentheses.
ProcessStat ProcessStatOf(int64_t pid) {
  const std::string line = ReadFile(fmt::format("/proc/{}/stat", pid)).value_or("");
  const size_t name_end = line.rfind(')');
  if (name_end == std::string::npos) return {};
  std::istringstream rest(line.substr(name_end + 1));
  ProcessStat status;
  rest >> status.state;
  constexpr int kStartTimeField = 22, kStateField = 3;
  for (int i = kStateField; i < kStartTimeField; ++i) rest >> status.start_time;
  return status;
}

// Returns whether a process has the id `pid`.  The error EPERM of kill() means that the process
// exists and belongs to another user.
bool Exists(int64_t pid) { return kill(static_cast<pid_t>(pid), 0) == 0 || errno != ESRCH; }

}  // namespace

std::string MachineId() {
  std::string boot = ReadFile("/proc/sys/kernel/random/boot_id").value_or("");
  boot.resize(std::min(boot.size(), boot.find('\n')));
  std::error_code error;
  const auto space = std::filesystem::read_symlink("/proc/self/ns/pid", error);
  return boot.empty() || error ? "" : boot + " " + space.string();
}

LivenessCheck::LivenessCheck(const std::string& machine, int64_t pid) {
  if (machine.empty() || machine != MachineId()) return;
  if (pid <= 0 || pid > std::numeric_limits<pid_t>::max() || !Exists(pid)) return;
  pid_ = pid;
  start_time_ = ProcessStatOf(pid).start_time;
}

bool LivenessCheck::HasEnded() const {
  if (pid_ == 0) return false;
  if (!Exists(pid_)) return true;
  const ProcessStat now = ProcessStatOf(pid_);
  // If the /proc entry is hidden (mount option hidepid), the start time is not known.  A new
  // process with the same id then looks like the old process, so HasEnded() takes the old process
  // for running.
  if (now.state.empty() || start_time_.empty()) return false;
  // Counts a zombie (Z) as ended.  A zombie runs no more; the kernel lists it only until its parent
  // reads its exit status.
  return now.state == "Z" || now.state == "X" || now.start_time != start_time_;
}

}  // namespace openr_host
