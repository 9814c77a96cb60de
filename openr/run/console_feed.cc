#include "openr/run/console_feed.h"

#include <fmt/format.h>
#include <poll.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <optional>
#include <stdexcept>
#include <string_view>
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

// Appends to `text_` what has arrived on standard input, until `text_` has `size_max` bytes; does
// not wait.  The rest stays in the pipe or in the terminal, so that the program that writes to
// standard input waits.
void ConsoleFeed::ReadStandardInput(size_t size_max) {
  pollfd input = {STDIN_FILENO, POLLIN, 0};
  while (is_open_ && text_.size() < size_max && poll(&input, 1, 0) > 0 && !IsInBackground()) {
    char buffer[4096];
    const ssize_t count =
        read(STDIN_FILENO, buffer, std::min(sizeof buffer, size_max - text_.size()));
    if (count <= 0) {
      is_open_ = false;
    } else {
      text_.append(buffer, static_cast<size_t>(count));
    }
  }
}

// Returns the length of the beginning of `text_` that can be typed now on terminals with room for
// `room` bytes: complete lines, and at the end of the input also an incomplete line.
size_t ConsoleFeed::ReadyLength(size_t room) const {
  // An incomplete line needs room for one more byte, because ConsoleInput::Enter() adds a newline.
  if (!is_open_ && text_.size() < room) return text_.size();
  if (room == 0) return 0;
  const size_t end = text_.rfind('\n', room - 1) + 1;  // 0: no line is complete
  // Breaks a line that even an empty terminal has no room for, because it would never be typed.
  const bool is_too_long = end == 0 && room == ConsoleInput::kUnreadMax && text_.size() >= room;
  return is_too_long ? room - 1 : end;
}

void ConsoleFeed::Feed(System* system) {
  // Takes the terminal with the least room, so that all robots get the same text.
  size_t room = ConsoleInput::kUnreadMax;
  for (int robot = 0; robot < system->robot_count(); ++robot) {
    if (!system->robot(robot).powered_off)
      room = std::min(room, system->console_input().RoomOf(robot));
  }
  ReadStandardInput(room);
  const size_t length = ReadyLength(room);
  if (length == 0) return;
  // Echoes the typed text only if it does not come from a terminal, because a terminal shows it
  // itself.
  system->console_input().set_echo(!is_terminal_);
  const std::string_view lines = std::string_view(text_).substr(0, length);
  // Ignores that a robot refuses the text, because only a robot that is off can have no room.
  for (int robot = 0; robot < system->robot_count(); ++robot) TypeText(system, robot, lines);
  text_.erase(0, length);
}

}  // namespace openr_host
