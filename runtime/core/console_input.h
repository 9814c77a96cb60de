// Console input: the lines that people type for the objects of a robot.  Each robot has one
// terminal.
//
// An object that reads the console waits until a line is there; other objects go on
// (field-notes.md, section 6).  Text can be read from the next frame boundary on, as all input from
// outside.
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

  // Adds text that was typed; a missing newline at its end is added.  Not called from a handler.
  void Feed(int robot, std::string_view text);

  // Registers a `listener` that Feed() calls at once with the text that was typed.
  using Listener = std::function<void(int robot, std::string_view text)>;
  void OnFeed(Listener listener) { listeners_.push_back(std::move(listener)); }

  // Returns the frame boundary at which typed text becomes readable; INT64_MAX if there is none.
  int64_t NextUs() const;
  // Makes the text readable that was typed before this frame boundary, and wakes a reader.
  void EnterDue();

  // Called in a handler: waits for a line, copies at most `size` bytes of it to `buffer` and
  // returns their number.  The rest of the line comes with the next call.  Echoes the bytes.  If
  // `is_gone` holds after the wait, because the reader was lost meanwhile, returns 0 and leaves the
  // line to the next reader.
  size_t Read(char* buffer, size_t size, const std::function<bool()>& is_gone = {});

  // Switches the echo off if the user's terminal has already shown the typed text.
  void set_echo(bool echo) { echo_ = echo; }

  // HandlerState::blocked_why of a reader.
  static constexpr std::string_view kWhy = "a line from the console";

  void HashState(Hasher* hasher) const;

 private:
  struct Terminal {
    std::string coming;             // typed, and not readable before `enters_us`
    int64_t enters_us = INT64_MAX;  // the frame boundary at which `coming` becomes readable
    std::string text;               // readable, and not read
    // The objects that wait for a line, each with the reply box it waits for.
    std::deque<std::pair<ObjectId, uint64_t>> readers;
  };

  void WakeNext(Terminal* terminal);
  void GiveUp(Terminal* terminal, ObjectId reader, uint64_t box);

  System* const system_;
  std::map<int, Terminal> terminals_;  // by robot
  std::vector<Listener> listeners_;
  bool echo_ = true;
};

}  // namespace openr_host
