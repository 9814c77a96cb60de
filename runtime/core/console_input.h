// What people type for the objects of a robot: one terminal per robot, line by line.
//
// An object that reads the console waits, and it alone, until a line is there (field-notes.md,
// section 6).  Lines enter at a frame boundary, as everything from outside does.
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

  // `text` as typed; a missing newline at its end is added.  Not from a handler.
  void Feed(int robot, std::string_view text);

  // `listener` hears what is fed, when it is fed.
  using Listener = std::function<void(int robot, std::string_view text)>;
  void OnFeed(Listener listener) { listeners_.push_back(std::move(listener)); }

  // When what was fed enters; INT64_MAX when nothing was.
  int64_t NextUs() const;
  // What enters now can be read from now on.
  void EnterDue();

  // In a handler: waits for a line and returns how many bytes of it, at most `size`, were put
  // at `buffer`; the rest comes with the next call.  What is read is echoed.  Woken when `is_gone`
  // holds, it returns 0: the line is the next reader's.
  size_t Read(char* buffer, size_t size, const std::function<bool()>& is_gone = {});

  // Off where a terminal has shown already what was typed.
  void set_echo(bool echo) { echo_ = echo; }

  // Object::blocked_why of a reader.
  static constexpr std::string_view kWhy = "a line from the console";

  void HashState(Hasher* hasher) const;

 private:
  struct Terminal {
    std::string coming;                                 // fed, not entered
    int64_t enters_us = INT64_MAX;                      // when it does
    std::string text;                                   // entered, not read
    std::deque<std::pair<ObjectId, uint64_t>> readers;  // who waits, for which reply box
  };

  void WakeNext(Terminal* terminal);
  void GiveUp(Terminal* terminal, ObjectId reader, uint64_t box);

  System* const system_;
  std::map<int, Terminal> terminals_;  // by robot
  std::vector<Listener> listeners_;
  bool echo_ = true;
};

}  // namespace openr_host
