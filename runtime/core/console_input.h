// Console input: the lines that people type for the objects of a robot.  Each robot has one
// terminal.
//
// An object that reads the console waits until a line has been typed; other objects go on meanwhile
// (field-notes.md, section 6).  Like all input from outside, typed text can be read from the next
// frame boundary on.
#pragma once

#include <cstddef>
#include <cstdint>
#include <deque>
#include <functional>
#include <map>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "runtime/core/message.h"

namespace openr_host {

class Hasher;
class System;

class ConsoleInput {
 public:
  explicit ConsoleInput(System* system) : system_(system) {}

  // Adds `text`, which was typed on the terminal of `robot`.  Adds a newline if `text` does not end
  // with a newline.  REQUIRES: not called in a handler.
  void Feed(int robot, std::string_view text);

  // Registers a `listener` that Feed() calls with the typed text, for recordings.  Feed() calls it
  // when the text is typed, and not only at the frame boundary where objects can read the text.
  using Listener = std::function<void(int robot, std::string_view text)>;
  void OnFeed(Listener listener) { listeners_.push_back(std::move(listener)); }

  // Returns the virtual time of the next frame boundary (a multiple of System::frame_us()) at which
  // typed text becomes readable, or INT64_MAX if no text is waiting.
  int64_t NextUs() const;
  // Makes typed text readable if its frame boundary has come.  Then wakes an object that waits for
  // a line.
  void EnterDue();

  // Waits for a line, copies at most `size` bytes of it to `buffer`, echoes these bytes and returns
  // their number.  The next call returns the rest of the line.  If `is_gone` returns true after the
  // wait, because the process of the caller has ended meanwhile, returns 0 and leaves the line to
  // the next object that waits.  REQUIRES: called in a handler.
  size_t Read(char* buffer, size_t size, const std::function<bool()>& is_gone = {});

  // Sets whether Read() echoes the text.  The echo is switched off if the user's terminal has
  // already shown the typed text.
  void set_echo(bool echo) { echo_ = echo; }

  // Describes to users what an object that reads the console waits for (HandlerState::blocked_why).
  static constexpr std::string_view kWhy = "a line from the console";

  void HashState(Hasher* hasher) const;

 private:
  struct Terminal {
    std::string coming;             // text that was typed and becomes readable at `enters_us`
    int64_t enters_us = INT64_MAX;  // the frame boundary at which `coming` becomes readable
    std::string text;               // text that is readable and has not been read yet
    // The objects that wait for a line, each with the reply box that will end its wait.
    std::deque<std::pair<ObjectId, uint64_t>> readers;
  };

  void WakeNext(Terminal* terminal);
  void GiveUp(Terminal* terminal, ObjectId reader, uint64_t box);

  System* const system_;
  std::map<int, Terminal> terminals_;  // by index of the robot
  std::vector<Listener> listeners_;
  bool echo_ = true;
};

}  // namespace openr_host
