// A script of timed inputs: openr run --events FILE.
//
//   # TIME [robot N] INPUT
//   2s      press chin for 300ms
//   +500ms  push 0 5 0            # 500 ms after the line above
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
  // Reads the script `file`; "" is a script without lines.  Throws std::runtime_error "FILE:LINE:
  // ..." if the file cannot be read, if a line has no time, or if the time of a line is before the
  // time of the line above it.
  explicit EventScript(const std::string& file);

  // Checks the script before the run.  Returns "", or "FILE:LINE: ..." for the first line that has
  // an unknown input or a wrong robot.
  std::string Check(const System& system) const;

  // Gives the robots the inputs of the script that are due now.  Called between frames of 8 ms.
  void Feed(System* system);

  // Removes the next event of the script if it is the input `input` to the robot number `robot`,
  // because another part of the program has already given the input to the robot.
  void Skip(int robot, const std::string& input);

  // Adds an error finding if some inputs of the script were not due before the end of the run.
  // Called at the end of the run.
  void ReportRest(System* system) const;

 private:
  struct Event {
    int64_t time_us;
    int robot;
    std::string input;
    std::string place;  // place of the line in the script: "FILE:LINE"
  };

  std::deque<Event> events_;  // events that are still to come, in order of time
};

}  // namespace openr_host
