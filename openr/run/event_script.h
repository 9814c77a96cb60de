// A script of timed inputs: openr run --events FILE.
//
//   # TIME [robot N] INPUT
//   2s      press chin for 300ms
//   +500ms  push 0 5 0            # so long after the line above
//   4s      robot 1 lift
//
// docs/inputs.md describes the inputs.
#pragma once

#include <cstdint>
#include <deque>
#include <string>

namespace openr_host {

class System;

class EventScript {
 public:
  // Reads `file`; "" is a script without lines.  Throws std::runtime_error "FILE:LINE: ..." when
  // the file cannot be read, or a line has no time or an earlier one than the line before.
  explicit EventScript(const std::string& file);

  // Checks the script before the run.  Returns "", or "FILE:LINE: ..." for the first line whose
  // input the robots of `system` do not know or which names a wrong robot.
  std::string Check(const System& system) const;

  // Gives the robots the inputs whose time has come.  Called between frames of 8 ms.
  void Feed(System* system);

  // Removes the next event if it is this input, because something else has already given it to the
  // robot.
  void Skip(int robot, const std::string& input);

  // Adds an error finding if the time of some inputs has not come.  Called at the end of the run.
  void ReportRest(System* system) const;

 private:
  struct Event {
    int64_t time_us;
    int robot;
    std::string input;
    std::string place;  // "FILE:LINE"
  };

  std::deque<Event> events_;  // in order of time
};

}  // namespace openr_host
