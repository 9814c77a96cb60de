// The built program at a pseudo-terminal, as a person sees it.
#pragma once

#include <fcntl.h>
#include <poll.h>
#include <spawn.h>
#include <stdlib.h>
#include <sys/ioctl.h>
#include <sys/wait.h>
#include <termios.h>
#include <unistd.h>

#include <chrono>
#include <csignal>
#include <string>
#include <vector>

extern char** environ;

namespace openr_host {

class TerminalRun {
 public:
  // Starts the program with a terminal of 80 columns as its standard streams, in a session of its
  // own, as a shell in a window would.  Its prompt begins with `prompt`, on a line of its own.
  TerminalRun(const std::vector<std::string>& arguments, const std::string& prompt)
      : prompt_("\n" + prompt), terminal_(posix_openpt(O_RDWR | O_NOCTTY | O_CLOEXEC)) {
    char name[64];
    if (terminal_ < 0 || grantpt(terminal_) != 0 || unlockpt(terminal_) != 0 ||
        ptsname_r(terminal_, name, sizeof name) != 0)
      return;
    const winsize size = {24, 80, 0, 0};
    ioctl(terminal_, TIOCSWINSZ, &size);
    posix_spawn_file_actions_t actions;
    posix_spawn_file_actions_init(&actions);
    posix_spawn_file_actions_addopen(&actions, STDIN_FILENO, name, O_RDWR, 0);
    posix_spawn_file_actions_adddup2(&actions, STDIN_FILENO, STDOUT_FILENO);
    posix_spawn_file_actions_adddup2(&actions, STDIN_FILENO, STDERR_FILENO);
    posix_spawnattr_t attributes;
    sigset_t signals;
    sigemptyset(&signals);
    sigaddset(&signals, SIGINT);
    posix_spawnattr_init(&attributes);
    posix_spawnattr_setsigdefault(&attributes, &signals);
    posix_spawnattr_setflags(&attributes, POSIX_SPAWN_SETSID | POSIX_SPAWN_SETSIGDEF);
    std::vector<char*> argv{const_cast<char*>(OPENR_PROGRAM)};
    for (const std::string& a : arguments) argv.push_back(const_cast<char*>(a.c_str()));
    argv.push_back(nullptr);
    if (posix_spawn(&child_, OPENR_PROGRAM, &actions, &attributes, argv.data(), environ) != 0)
      child_ = -1;
    posix_spawnattr_destroy(&attributes);
    posix_spawn_file_actions_destroy(&actions);
  }
  ~TerminalRun() {
    if (child_ > 0) kill(-child_, SIGKILL);
    Finish();
    close(terminal_);
  }
  TerminalRun(const TerminalRun&) = delete;
  TerminalRun& operator=(const TerminalRun&) = delete;

  void Type(const std::string& keys) {
    if (write(terminal_, keys.data(), keys.size()) != static_cast<ssize_t>(keys.size())) Stop();
  }

  // Types `keys` and returns what the program shows up to the next prompt behind the text `end`,
  // which is part of it.  Returns "" if `end` or a prompt does not come within a minute.
  std::string Ask(const std::string& keys, const std::string& end) {
    const size_t from = shown_.size();
    Type(keys);
    if (!WaitFor(end, from)) return "";
    // The last character of `end` may be the end of the line in front of the prompt.
    if (!WaitFor(prompt_, shown_.find(end, from) + end.size() - 1)) return "";
    return shown_.substr(from);
  }

  bool WaitFor(const std::string& text, size_t from = 0) {
    const auto deadline = std::chrono::steady_clock::now() + std::chrono::minutes(1);
    while (shown_.find(text, from) == std::string::npos) {
      if (std::chrono::steady_clock::now() > deadline || !ReadSome()) return false;
    }
    return true;
  }

  // Returns whether the terminal echoes and edits lines itself, as it did before the program.
  bool IsAsBefore() const {
    termios settings;
    constexpr tcflag_t kCooked = ICANON | ECHO | ISIG;
    return tcgetattr(terminal_, &settings) == 0 && (settings.c_lflag & kCooked) == kCooked &&
           settings.c_cc[VINTR] == '\003';
  }

  // Waits for the end, and returns the exit status; 128 + n after signal n.
  int Finish() {
    while (ReadSome()) {
    }
    if (child_ <= 0) return status_;
    int status = 0;
    waitpid(child_, &status, 0);
    child_ = -1;
    return status_ = WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
  }

  const std::string& shown() const { return shown_; }
  pid_t pid() const { return child_; }

 private:
  void Stop() {
    if (child_ > 0) kill(-child_, SIGKILL);
  }

  // Returns false when no process has the terminal any more, or nothing comes for a minute.
  bool ReadSome() {
    pollfd wanted = {terminal_, POLLIN, 0};
    if (terminal_ < 0 || poll(&wanted, 1, 60'000) <= 0) {
      Stop();
      return false;
    }
    char buffer[4096];
    const ssize_t n = read(terminal_, buffer, sizeof buffer);
    if (n <= 0) return false;
    shown_.append(buffer, static_cast<size_t>(n));
    return true;
  }

  const std::string prompt_;
  const int terminal_;
  pid_t child_ = -1;
  int status_ = -1;
  std::string shown_;
};

}  // namespace openr_host
