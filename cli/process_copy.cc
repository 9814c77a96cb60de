#include "cli/process_copy.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <poll.h>
#include <signal.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <stdexcept>

#include "cli/exit_code.h"

namespace openr_host {
namespace {

void Flush(Flushed flushed) {
  switch (flushed) {
    case Flushed::kNone:
      return;
    case Flushed::kOwn:
      std::fflush(stdout);
      std::fflush(stderr);
      return;
    case Flushed::kAll:
      std::fflush(nullptr);
      return;
  }
}

}  // namespace

pid_t CopyProcess(Flushed flushed, Orphan orphan) {
  Flush(flushed);
  const pid_t original = getpid();
  const pid_t copy = fork();
  if (copy == 0 && orphan == Orphan::kIsKilled) {
    prctl(PR_SET_PDEATHSIG, SIGKILL);
    // Ends the copy here if the original has ended before prctl(), because the kernel does not kill
    // the copy then.
    if (getppid() != original) _exit(0);
  }
  return copy;
}

void EndCopy() {
  std::fflush(nullptr);
  _exit(0);
}

ProcessCopy StartCopy(Orphan orphan, const std::function<void(int answers)>& work) {
  int ends[2];
  if (pipe2(ends, O_CLOEXEC) != 0) {
    throw std::runtime_error(
        fmt::format("no pipe to a copy of this process: {}", std::strerror(errno)));
  }
  const pid_t child = CopyProcess(Flushed::kAll, orphan);
  if (child < 0) {
    const int error = errno;
    close(ends[0]);
    close(ends[1]);
    throw std::runtime_error(fmt::format("cannot fork: {}", std::strerror(error)));
  }
  if (child == 0) {
    close(ends[0]);
    work(ends[1]);
    EndCopy();
  }
  close(ends[1]);
  return {child, ends[0]};
}

std::string StartThroughCopy(const std::function<int()>& start) {
  const pid_t copy = CopyProcess(Flushed::kNone, Orphan::kGoesOn);
  if (copy < 0) return std::strerror(errno);
  if (copy == 0) _exit(start());  // an errno is less than 256, so it fits into an exit status
  const int status = WaitForEnd(copy);
  if (WIFSIGNALED(status)) {
    return fmt::format("the process that was to start it was killed by signal {} ({})",
                       WTERMSIG(status), strsignal(WTERMSIG(status)));
  }
  return WEXITSTATUS(status) == 0 ? "" : std::strerror(WEXITSTATUS(status));
}

std::string ReadToEnd(int descriptor, std::FILE* echo, const std::function<void()>& while_waiting) {
  constexpr int kPauseMs = 200;  // time between two calls of `while_waiting`
  std::string text;
  char buffer[8192];
  for (;;) {
    if (while_waiting) {
      while_waiting();
      pollfd wanted = {descriptor, POLLIN, 0};
      if (poll(&wanted, 1, kPauseMs) <= 0) continue;
    }
    const ssize_t count = read(descriptor, buffer, sizeof buffer);
    if (count < 0 && errno == EINTR) continue;
    if (count <= 0) return text;
    text.append(buffer, static_cast<size_t>(count));
    if (echo != nullptr) std::fwrite(buffer, 1, static_cast<size_t>(count), echo);
  }
}

int WaitForEnd(pid_t child) {
  int status = 0;
  while (waitpid(child, &status, 0) < 0 && errno == EINTR) {
  }
  return status;
}

void WaitForAllCopies() {
  while (waitpid(-1, nullptr, 0) > 0 || errno == EINTR) {
  }
}

int ExitCodeOf(int status) { return WIFEXITED(status) ? WEXITSTATUS(status) : kExitWrong; }

}  // namespace openr_host
