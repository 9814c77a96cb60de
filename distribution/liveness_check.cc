#include "distribution/liveness_check.h"

#include <errno.h>
#include <fmt/format.h>
#include <signal.h>

#include <filesystem>
#include <fstream>
#include <limits>
#include <sstream>

namespace openr_host {
namespace {

struct ProcessStat {
  std::string state;  // "": hidden, or it is not there
  std::string start_time;
};

// The name, in parentheses, may have spaces and parentheses of its own.
ProcessStat ProcessStatOf(int64_t pid) {
  std::ifstream file(fmt::format("/proc/{}/stat", pid));
  std::string line;
  std::getline(file, line);
  const size_t name_end = line.rfind(')');
  if (name_end == std::string::npos) return {};
  std::istringstream rest(line.substr(name_end + 1));
  ProcessStat status;
  rest >> status.state;
  constexpr int kStartTimeField = 22, kStateField = 3;
  for (int i = kStateField; i < kStartTimeField; ++i) rest >> status.start_time;
  return status;
}

bool Exists(int64_t pid) { return kill(static_cast<pid_t>(pid), 0) == 0 || errno != ESRCH; }

}  // namespace

std::string MachineId() {
  std::string boot;
  std::ifstream("/proc/sys/kernel/random/boot_id") >> boot;
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
  if (now.state.empty() || start_time_.empty()) return false;
  return now.state == "Z" || now.state == "X" || now.start_time != start_time_;
}

}  // namespace openr_host
