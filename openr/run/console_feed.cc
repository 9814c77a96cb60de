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

// Returns the number of bytes that can be typed now on every robot that is on.  Leaves out robots
// whose programs have never read, unless no program of any robot has: such a robot would stop the
// input of the others for ever when its terminal is full.
size_t RoomOfReaders(System* system) {
  const ConsoleInput& console = system->console_input();
  size_t room = ConsoleInput::kUnreadMax;
  size_t room_of_readers = ConsoleInput::kUnreadMax;
  bool has_reader = false;
  for (int robot = 0; robot < system->robot_count(); ++robot) {
    if (system->robot(robot).powered_off) continue;
    room = std::min(room, console.RoomOf(robot));
    if (!console.HasReader(robot)) continue;
    has_reader = true;
    room_of_readers = std::min(room_of_readers, console.RoomOf(robot));
  }
  return has_reader ? room_of_readers : room;
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

// Types `lines` on the terminal of `robot`.  If the terminal has no room for them, the robot misses
// them.  A robot that is on has room unless its programs have never read.
void ConsoleFeed::Type(System* system, int robot, std::string_view lines) {
  if (system->console_input().RoomOf(robot) >= ConsoleInput::EnteredSize(lines)) {
    // Ignores that the robot refuses the text, because only a robot that is off refuses it.
    TypeText(system, robot, lines);
    return;
  }
  if (system->robot(robot).powered_off || !is_reported_.insert(robot).second) return;
  system->AddFindingAboutRobot(
      robot, Severity::kWarning,
      fmt::format("console: typed text is missed from here on: no program of the robot has read so "
                  "far, {} bytes wait, and the other robots are not to wait for it",
                  ConsoleInput::kUnreadMax - system->console_input().RoomOf(robot)));
}

void ConsoleFeed::Feed(System* system) {
  const size_t room = RoomOfReaders(system);
  ReadStandardInput(room);
  const size_t length = ReadyLength(room);
  if (length == 0) return;
  // Echoes the typed text only if it does not come from a terminal, because a terminal shows it
  // itself.
  system->console_input().set_echo(!is_terminal_);
  const std::string_view lines = std::string_view(text_).substr(0, length);
  for (int robot = 0; robot < system->robot_count(); ++robot) Type(system, robot, lines);
  text_.erase(0, length);
}

}  // namespace openr_host
