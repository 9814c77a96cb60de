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

// Returns whether a program of any robot that is on has read.
bool HasAnyReader(System* system) {
  for (int robot = 0; robot < system->robot_count(); ++robot) {
    if (!system->robot(robot).powered_off && system->console_input().HasReader(robot)) return true;
  }
  return false;
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

// Returns whether text waits that cannot be typed on a terminal with room for `room` bytes.  An
// incomplete line waits for its end and not for room.
bool ConsoleFeed::IsBlocked(size_t room) const {
  if (ReadyLength(room) > 0) return false;
  return is_open_ ? text_.size() > room : !text_.empty();
}

// Returns the number of bytes that can be typed now on every robot that is on.  Leaves out robots
// that miss all text.
size_t ConsoleFeed::RoomOfAll(System* system) const {
  size_t room = ConsoleInput::kUnreadMax;
  for (int robot = 0; robot < system->robot_count(); ++robot) {
    if (system->robot(robot).powered_off || missing_.contains(robot)) continue;
    room = std::min(room, system->console_input().RoomOf(robot));
  }
  return room;
}

// Updates which robots miss all text.
void ConsoleFeed::UpdateMissing(System* system) {
  const bool has_reader = HasAnyReader(system);
  for (int robot = 0; robot < system->robot_count(); ++robot)
    UpdateMissing(system, robot, has_reader);
}

// Updates whether `robot` misses all text.  `has_reader` says whether a program of any robot has
// read.  As long as no program of any robot has, all robots are waited for without a time limit.
void ConsoleFeed::UpdateMissing(System* system, int robot, bool has_reader) {
  const ConsoleInput& console = system->console_input();
  if (console.HasReader(robot)) missing_.erase(robot);
  const bool is_waited_for = has_reader && !console.HasReader(robot) &&
                             !system->robot(robot).powered_off && !missing_.contains(robot) &&
                             IsBlocked(console.RoomOf(robot));
  if (!is_waited_for) {
    waits_since_us_.erase(robot);
    return;
  }
  const int64_t since_us = waits_since_us_.emplace(robot, system->now_us()).first->second;
  if (system->now_us() - since_us < kPatienceUs) return;
  waits_since_us_.erase(robot);
  missing_.insert(robot);
  system->AddFindingAboutRobot(
      robot, Severity::kWarning,
      fmt::format("console: typed text is missed until a program of the robot reads: no program of "
                  "it has read so far, {} bytes wait, and the other robots are not to wait for it",
                  ConsoleInput::kUnreadMax - console.RoomOf(robot)));
}

void ConsoleFeed::Feed(System* system) {
  // Reads one byte more than can be typed, so that IsBlocked() knows whether more text waits.
  ReadStandardInput(RoomOfAll(system) + 1);
  UpdateMissing(system);
  const size_t length = ReadyLength(RoomOfAll(system));
  if (length == 0) return;
  // Echoes the typed text only if it does not come from a terminal, because a terminal shows it
  // itself.
  system->console_input().set_echo(!is_terminal_);
  const std::string_view lines = std::string_view(text_).substr(0, length);
  for (int robot = 0; robot < system->robot_count(); ++robot) {
    // Ignores that a robot refuses the text, because only a robot that is off refuses it.
    if (!missing_.contains(robot)) TypeText(system, robot, lines);
  }
  text_.erase(0, length);
}

}  // namespace openr_host
