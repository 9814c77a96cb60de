#include "distribution/child_process.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <signal.h>
#include <string.h>
#include <sys/wait.h>
#include <unistd.h>

#include <stdexcept>

#include "runtime/base/program_start.h"

namespace openr_host {

ChildProcess::ChildProcess(std::string name, const std::vector<std::string>& command,
                           bool is_interactive)
    : name_(std::move(name)) {
  ProgramStart program(command);
  program.Give(STDERR_FILENO, STDOUT_FILENO);
  if (!is_interactive) {
    program.OpenNull(STDIN_FILENO, O_RDONLY);
    // Puts the child into a process group of its own.  The child then gets no Ctrl-C from the
    // terminal, so this program decides when the child ends.
    program.LeaveGroup();
  }
  const int error = program.Start(&pid_);
  if (error != 0)
    throw std::runtime_error(
        fmt::format("process '{}': {} cannot be started: {}", name_, command[0], strerror(error)));
}

ChildProcess::~ChildProcess() { Kill(); }

bool ChildProcess::UpdateStatus(bool waits) {
  if (!ended_ && waitpid(pid_, &status_, waits ? 0 : WNOHANG) == pid_) ended_ = true;
  return ended_;
}

std::string ChildProcess::EndText() {
  if (!UpdateStatus(false)) return "";
  if (WIFSIGNALED(status_))
    return fmt::format("process '{}' (pid {}) was killed by signal {} ({})", name_, pid_,
                       WTERMSIG(status_), strsignal(WTERMSIG(status_)));
  return fmt::format("process '{}' (pid {}) ended with status {}", name_, pid_,
                     WEXITSTATUS(status_));
}

bool ChildProcess::WaitForEnd(int64_t limit_ms) {
  for (int64_t waited_ms = 0;; waited_ms += 2) {
    if (UpdateStatus(false)) return true;
    if (waited_ms >= limit_ms) return false;
    usleep(2000);
  }
}

void ChildProcess::Kill() {
  if (UpdateStatus(false)) return;
  kill(pid_, SIGKILL);
  UpdateStatus(true);
}

}  // namespace openr_host
