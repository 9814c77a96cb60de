#include "distribution/child_process.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <signal.h>
#include <spawn.h>
#include <string.h>
#include <sys/wait.h>
#include <unistd.h>

#include <stdexcept>

extern char** environ;

namespace openr_host {

ChildProcess::ChildProcess(std::string name, const std::vector<std::string>& command,
                           bool is_interactive)
    : name_(std::move(name)) {
  std::vector<char*> words;
  words.reserve(command.size() + 1);
  for (const std::string& word : command) words.push_back(const_cast<char*>(word.c_str()));
  words.push_back(nullptr);
  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  posix_spawn_file_actions_adddup2(&actions, STDERR_FILENO, STDOUT_FILENO);
  if (!is_interactive)
    posix_spawn_file_actions_addopen(&actions, STDIN_FILENO, "/dev/null", O_RDONLY, 0);
  posix_spawnattr_t attributes;
  posix_spawnattr_init(&attributes);
  // Gives the child the default actions of SIGPIPE and SIGXFSZ.  This program ignores these
  // signals, and a child would ignore them, too.  But other programs, such as debuggers, expect
  // that SIGPIPE ends them.
  sigset_t signals;
  sigemptyset(&signals);
  sigaddset(&signals, SIGPIPE);
  sigaddset(&signals, SIGXFSZ);
  posix_spawnattr_setsigdefault(&attributes, &signals);
  short flags = POSIX_SPAWN_SETSIGDEF;
  // Puts the child into a process group of its own.  The child then gets no Ctrl-C from the
  // terminal, so this program decides when the child ends.
  if (!is_interactive) flags |= POSIX_SPAWN_SETPGROUP;
  posix_spawnattr_setpgroup(&attributes, 0);
  posix_spawnattr_setflags(&attributes, flags);
  const int error = posix_spawnp(&pid_, words[0], &actions, &attributes, words.data(), environ);
  posix_spawn_file_actions_destroy(&actions);
  posix_spawnattr_destroy(&attributes);
  if (error != 0)
    throw std::runtime_error(
        fmt::format("process '{}': {} cannot be started: {}", name_, command[0], strerror(error)));
}

ChildProcess::~ChildProcess() {
  if (UpdateStatus(false)) return;
  kill(pid_, SIGKILL);
  UpdateStatus(true);
}

bool ChildProcess::UpdateStatus(bool waits) {
  if (!ended_ && waitpid(pid_, &status_, waits ? 0 : WNOHANG) == pid_) ended_ = true;
  return ended_;
}

std::string ChildProcess::HowItEnded() {
  if (!UpdateStatus(false)) return "";
  if (WIFSIGNALED(status_))
    return fmt::format("process '{}' (pid {}) was killed by signal {} ({})", name_, pid_,
                       WTERMSIG(status_), strsignal(WTERMSIG(status_)));
  return fmt::format("process '{}' (pid {}) ended with status {}", name_, pid_,
                     WEXITSTATUS(status_));
}

void ChildProcess::WaitForEnd(int64_t limit_ms) {
  for (int64_t waited_ms = 0; waited_ms < limit_ms; waited_ms += 2) {
    if (UpdateStatus(false)) return;
    usleep(2000);
  }
  kill(pid_, SIGKILL);
  UpdateStatus(true);
}

}  // namespace openr_host
