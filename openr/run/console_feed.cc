#include "openr/run/console_feed.h"

#include <fmt/format.h>
#include <poll.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <optional>
#include <stdexcept>
#include <utility>

#include "runtime/base/read_file.h"
#include "runtime/core/system.h"
#include "runtime/core/system_inputs.h"

namespace openr_host {
namespace {

// Returns whether standard input is the terminal of this process, but the process is in the
// background there.  Such a process must not read from the terminal, because the system would stop
// it (SIGTTIN).
bool IsInBackground() {
  const pid_t foreground = tcgetpgrp(STDIN_FILENO);
  return foreground != -1 && foreground != getpgrp();
}

}  // namespace

ConsoleFeed::ConsoleFeed(const std::string& file)
    : is_open_(file == "-" || (file.empty() && isatty(STDIN_FILENO) != 0)) {
  is_terminal_ = is_open_ && isatty(STDIN_FILENO) != 0;
  if (file.empty() || is_open_) return;
  std::optional<std::string> text = ReadFile(file);
  if (!text) {
    throw std::runtime_error(
        fmt::format("--stdin {}: cannot be read: {}", file, std::strerror(errno)));
  }
  text_ = std::move(*text);
}

// Returns the complete lines that have arrived on standard input; does not wait.  Keeps an
// incomplete line for a later call.  At the end of standard input, returns the incomplete line as
// well.
std::string ConsoleFeed::TakeLines() {
  pollfd input = {STDIN_FILENO, POLLIN, 0};
  while (is_open_ && poll(&input, 1, 0) > 0 && !IsInBackground()) {
    char buffer[4096];
    const ssize_t count = read(STDIN_FILENO, buffer, sizeof buffer);
    if (count <= 0) {
      is_open_ = false;
    } else {
      text_.append(buffer, static_cast<size_t>(count));
    }
  }
  if (!is_open_) return std::exchange(text_, "");
  const size_t end = text_.rfind('\n') + 1;  // length of the complete lines; 0: no line is complete
  std::string lines = text_.substr(0, end);
  text_.erase(0, end);
  return lines;
}

void ConsoleFeed::Feed(System* system) {
  const std::string lines = TakeLines();
  if (lines.empty()) return;
  // Echoes the typed text only if it does not come from a terminal, because a terminal shows it
  // itself.
  system->console_input().set_echo(!is_terminal_);
  for (int robot = 0; robot < system->robot_count(); ++robot) TypeText(system, robot, lines);
}

}  // namespace openr_host
