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
#include <string>
#include <string_view>
#include <utility>

#include "runtime/core/message.h"

namespace openr_host {

class Hasher;
class System;

class ConsoleInput {
 public:
  explicit ConsoleInput(System* system) : system_(system) {}

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
  };

  void WakeNext(Terminal* terminal);
  void GiveUp(Terminal* terminal, ObjectId reader, uint64_t box);

  System* const system_;
  std::map<int, Terminal> terminals_;  // the key is the number of the robot
  bool echo_ = true;
};

}  // namespace openr_host
