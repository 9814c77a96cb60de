#include "openr/live/live_folder.h"

#include <fmt/format.h>
#include <signal.h>
#include <sys/socket.h>
#include <sys/stat.h>
#include <sys/un.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <charconv>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <stdexcept>

#include "runtime/base/characters.h"
#include "runtime/base/temp_folder.h"

namespace openr_host {
namespace {

constexpr size_t kNameMax = 40;

bool IsRunning(int process) { return kill(process, 0) == 0 || errno == EPERM; }

std::string Describe(const std::vector<LiveRun>& runs) {
  if (runs.empty()) return "no run of this user goes on";
  std::string text;
  for (const LiveRun& run : runs)
    text += fmt::format("{}{} (process {})", text.empty() ? "" : ", ", run.name, run.process);
  return "runs that go on: " + text;
}

}  // namespace

std::string LiveFolder() {
  const char* const runtime = std::getenv("XDG_RUNTIME_DIR");
  const std::string folder = runtime != nullptr && *runtime == '/'
                                 ? fmt::format("{}/openr-host", runtime)
                                 : fmt::format("{}/openr-host-{}", TemporaryFiles(), geteuid());
  if (mkdir(folder.c_str(), 0700) != 0 && errno != EEXIST)
    throw std::runtime_error(fmt::format("{}: cannot be made: {}", folder, std::strerror(errno)));
  // Checks that the folder for the sockets of runs is a folder of this user.  The folder may lie in
  // the folder for temporary files, in which everybody may write, so another user may have made a
  // file or folder of this name.  lstat() does not follow links, so a link to another folder is
  // refused, too.
  struct stat status;
  if (lstat(folder.c_str(), &status) != 0 || !S_ISDIR(status.st_mode) ||
      status.st_uid != geteuid() || (status.st_mode & 077) != 0) {
    throw std::runtime_error(
        fmt::format("{}: must be a folder of this user that nobody else can enter", folder));
  }
  return folder;
}

std::string LiveSocketPath(const std::string& name) {
  std::string file = name.substr(0, kNameMax);
  for (char& c : file) {
    if (!IsLetter(c) && !IsDigit(c) && c != '_' && c != '-') c = '_';
  }
  return fmt::format("{}/{}.{}", LiveFolder(), file, getpid());
}

bool IsLiveSocketOpen(const std::string& path) {
  // Tries to connect a socket of another type, because this attempt always fails: with EPROTOTYPE
  // if the socket at `path` is open, with ECONNREFUSED if it is not (man 7 unix).  So this function
  // does not wait for the run, and does not take the place of a client.
  sockaddr_un address{};
  address.sun_family = AF_UNIX;
  if (path.size() >= sizeof address.sun_path) return false;
  std::memcpy(address.sun_path, path.c_str(), path.size() + 1);
  const int descriptor = socket(AF_UNIX, SOCK_DGRAM | SOCK_CLOEXEC | SOCK_NONBLOCK, 0);
  if (descriptor < 0) return true;  // the socket counts as open, because its run may go on
  const bool is_refused =
      connect(descriptor, reinterpret_cast<const sockaddr*>(&address), sizeof address) != 0 &&
      (errno == ECONNREFUSED || errno == ENOENT);
  close(descriptor);
  return !is_refused;
}

std::vector<LiveRun> LiveRuns() {
  std::vector<LiveRun> runs;
  std::error_code error;
  for (const auto& entry : std::filesystem::directory_iterator(LiveFolder(), error)) {
    const std::string file = entry.path().filename();
    const size_t dot = file.rfind('.');
    LiveRun run{file.substr(0, dot), 0, entry.path()};
    const char* const end = file.data() + file.size();
    if (dot == std::string::npos ||
        std::from_chars(file.data() + dot + 1, end, run.process).ptr != end)
      continue;
    // Lists a run if its socket is open, even if its process is not found: the process may be in
    // another container that shares this folder.  The process id alone would not prove that the run
    // goes on, because the id may now belong to another process.
    if (IsLiveSocketOpen(run.socket)) {
      runs.push_back(std::move(run));
    } else if (!IsRunning(run.process)) {
      // Removes the socket of a process that was killed and could not remove it.  Keeps a socket
      // whose process exists, because the process may be a run that is just opening the socket.
      unlink(run.socket.c_str());
    }
  }
  std::sort(runs.begin(), runs.end(), [](const LiveRun& a, const LiveRun& b) {
    return std::pair(a.name, a.process) < std::pair(b.name, b.process);
  });
  return runs;
}

LiveRun FindLiveRun(const std::string& wanted) {
  const std::vector<LiveRun> runs = LiveRuns();
  std::vector<LiveRun> fitting;
  for (const LiveRun& run : runs) {
    if (run.name == wanted || std::to_string(run.process) == wanted) fitting.push_back(run);
  }
  if (fitting.size() == 1) return fitting[0];
  throw std::runtime_error(fitting.empty()
                               ? fmt::format("there is no run '{}'; {}", wanted, Describe(runs))
                               : fmt::format("'{}' names several runs; give the process id; {}",
                                             wanted, Describe(fitting)));
}

}  // namespace openr_host
