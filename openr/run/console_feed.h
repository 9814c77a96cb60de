// ConsoleFeed, which gives console input to the robots' programs: a file, or text that a user
// types.
#pragma once

#include <cstddef>
#include <set>
#include <string>
#include <string_view>

namespace openr_host {

class System;

class ConsoleFeed {
 public:
  // Opens the source of the console input.  If `file` is "-", or if it is "" and standard input is
  // a terminal, the source is standard input, and each Feed() gives the lines that have arrived.
  // If `file` is "" and standard input is no terminal, there is no input.  The content of any other
  // file is given from the start of the run.  Throws std::runtime_error if the file cannot be read.
  explicit ConsoleFeed(const std::string& file);

  // Gives every robot of `system` the console input since the last call: lines from standard input,
  // or of the file that the constructor got.  Gives only as much as the terminals of all robots
  // that are on have room for (ConsoleInput::RoomOf()); the rest follows in later calls, when
  // programs have read.  Does not read from standard input meanwhile, so that its writer waits.
  // Does not wait for a robot whose programs have never read if programs of another robot have:
  // this robot misses text for which its terminal has no room, and a finding says so.  Breaks a
  // line that is longer than the terminal of a robot can hold.
  void Feed(System* system);

 private:
  void ReadStandardInput(size_t size_max);
  void Type(System* system, int robot, std::string_view lines);
  size_t ReadyLength(size_t room) const;

  std::string text_;  // input that has arrived and was not given to robots yet
  // True: standard input is a terminal, which shows the typed text itself, so that the program need
  // not show it.
  bool is_terminal_ = false;
  bool is_open_ = false;       // true: more text may arrive on standard input
  std::set<int> is_reported_;  // robots about which a finding says that they miss text
};

}  // namespace openr_host
