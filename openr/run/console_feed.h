// ConsoleFeed, which gives console input to the robots' programs: a file, or text that a user
// types.
#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <set>
#include <string>

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
  //
  // Waits only kPatienceUs for a robot whose programs have never read if programs of another robot
  // have.  After that the robot misses all text until one of its programs reads, and a finding says
  // so.  Breaks a line that is longer than the terminal of a robot can hold.
  void Feed(System* system);

  // The virtual time for which text waits for a robot whose programs have never read.  It is our
  // choice: long enough for programs that begin to read a little later than those of another robot.
  static constexpr int64_t kPatienceUs = 5'000'000;

 private:
  void ReadStandardInput(size_t size_max);
  size_t RoomOfAll(System* system) const;
  size_t ReadyLength(size_t room) const;
  bool IsBlocked(size_t room) const;
  void UpdateMissing(System* system);
  void UpdateMissing(System* system, int robot, bool has_reader);

  std::string text_;  // input that has arrived and was not given to robots yet
  // True: standard input is a terminal, which shows the typed text itself, so that the program need
  // not show it.
  bool is_terminal_ = false;
  bool is_open_ = false;  // true: more text may arrive on standard input
  // Robots that Feed() waits for although their programs have never read, each with the virtual
  // time at which this wait began.
  std::map<int, int64_t> waits_since_us_;
  std::set<int> missing_;  // robots that miss all text until one of their programs reads
};

}  // namespace openr_host
