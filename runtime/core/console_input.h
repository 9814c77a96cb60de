// Console input: the lines that people type for the objects of a robot.  Each robot has one
// terminal.
//
// An object that reads the console waits until a line has been typed; other objects go on meanwhile
// (field-notes.md, section 6).  The text comes from the input `type` (system_inputs.h).
#pragma once

#include <cstddef>
#include <cstdint>
#include <deque>
#include <functional>
#include <map>
#include <memory>
#include <string>
#include <string_view>
#include <utility>

#include "runtime/core/message.h"

namespace openr_host {

class Hasher;
class System;

class ConsoleInput {
 public:
  // The largest number of bytes of typed text that a robot holds for programs that have not read it
  // yet.  The limit is our choice.  It bounds the memory that text from outside can take: without
  // a program that reads the console, all typed text would stay until the end of the run.
  static constexpr size_t kUnreadMax = size_t{64} << 10;

  explicit ConsoleInput(System* system) : system_(system) {}

  // Returns how many bytes can be typed on the terminal of `robot` now: kUnreadMax minus the bytes
  // of unread text, and minus the bytes that Reserve() keeps free.
  size_t RoomOf(int robot) const;

  // Returns whether a program of `robot` has called Read() since the beginning of the run.
  bool HasReader(int robot) const;

  // Keeps `bytes` bytes free on the terminal of `robot`, for the text of an input that waits for
  // its frame boundary.  They are free for other text again when the last copy of the result is
  // destroyed.
  std::shared_ptr<const void> Reserve(int robot, size_t bytes);

  // Returns the number of bytes that Enter() adds to the terminal for `text`.
  static size_t EnteredSize(std::string_view text) {
    return text.size() + (text.ends_with('\n') ? 0 : 1);
  }

  // Gives `text`, which was typed on the terminal of `robot`, to the objects that read from this
  // terminal, and wakes the first object that waits for a line.  Adds a newline if `text` does not
  // end with a newline.  REQUIRES: not called in a handler.
  void Enter(int robot, std::string_view text);

  // Waits until the terminal of the calling object's robot has a line.  Copies at most `size` bytes
  // of the line to `buffer`, echoes these bytes and returns their number.  The next call returns
  // the rest of the line.  After the wait calls `is_gone`, which returns true if the process of the
  // caller has ended meanwhile.  In this case returns 0 and leaves the line to the next object that
  // waits.  REQUIRES: called in a handler.
  size_t Read(char* buffer, size_t size, const std::function<bool()>& is_gone = {});

  // Sets whether Read() echoes the text.  The echo is switched off if the user's terminal has
  // already shown the typed text.
  void set_echo(bool echo) { echo_ = echo; }

  // Describes to users what an object that reads the console waits for (WaitState::why()).
  static constexpr std::string_view kWaitReason = "a line from the console";

  void HashState(Hasher* hasher) const;

 private:
  struct Terminal {
    std::string text;  // text that has not been read yet
    // The objects that wait for a line, each with the reply box that will end its wait.
    std::deque<std::pair<ObjectId, uint64_t>> readers;
    bool has_reader = false;  // see HasReader()
  };

  void WakeNext(Terminal* terminal);
  void GiveUp(Terminal* terminal, ObjectId reader, uint64_t box);

  System* const system_;
  std::map<int, Terminal> terminals_;  // the key is the number of the robot
  // The number of bytes for which Reserve() keeps room; the key is the number of the robot.  Each
  // number is shared with the results of Reserve(), which may be destroyed after this object.  Not
  // part of HashState(), because the inputs that wait are part of Inputs::HashState().
  std::map<int, std::shared_ptr<size_t>> reserved_;
  bool echo_ = true;
};

}  // namespace openr_host
