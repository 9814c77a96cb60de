#include "distribution/pulse.h"

#include <errno.h>
#include <fmt/format.h>
#include <signal.h>

#include <filesystem>
#include <fstream>
#include <limits>
#include <sstream>

namespace openr_host {
namespace {

struct Status {
  std::string state;  // "": hidden, or it is not there
  std::string began;
};

// The name, in parentheses, may have spaces and parentheses of its own.
Status StatusOf(int64_t pid) {
  std::ifstream file(fmt::format("/proc/{}/stat", pid));
  std::string line;
  std::getline(file, line);
  const size_t name_end = line.rfind(')');
  if (name_end == std::string::npos) return {};
  std::istringstream rest(line.substr(name_end + 1));
  Status status;
  rest >> status.state;
  constexpr int kBeganField = 22, kStateField = 3;
  for (int i = kStateField; i < kBeganField; ++i) rest >> status.began;
  return status;
}

bool IsThere(int64_t pid) { return kill(static_cast<pid_t>(pid), 0) == 0 || errno != ESRCH; }

}  // namespace

std::string MachineName() {
  std::string boot;
  std::ifstream("/proc/sys/kernel/random/boot_id") >> boot;
  std::error_code error;
  const auto space = std::filesystem::read_symlink("/proc/self/ns/pid", error);
  return boot.empty() || error ? "" : boot + " " + space.string();
}

Pulse::Pulse(const std::string& machine, int64_t pid) {
  if (machine.empty() || machine != MachineName()) return;
  if (pid <= 0 || pid > std::numeric_limits<pid_t>::max() || !IsThere(pid)) return;
  pid_ = pid;
  began_ = StatusOf(pid).began;
}

bool Pulse::HasEnded() const {
  if (pid_ == 0) return false;
  if (!IsThere(pid_)) return true;
  const Status now = StatusOf(pid_);
  if (now.state.empty() || began_.empty()) return false;
  return now.state == "Z" || now.state == "X" || now.began != began_;
}

}  // namespace openr_host
