// ProgressLine: a line on the terminal that shows the progress of an exploration.
#pragma once

#include <cstdint>
#include <string>

namespace openr_host {

// Returns the text of the line: "openr: 40 of 100 seeds, about 90 s left".  `what` is the
// plural of what is counted, such as "seeds".  The time is left out at the beginning, when it is
// not known.
std::string ProgressText(uint64_t done, uint64_t total, const std::string& what, double elapsed_s);

// Draws the line on a terminal; each drawing replaces the one before.  Writes nothing if
// `descriptor` is no terminal.
class ProgressLine {
 public:
  ProgressLine(int descriptor, uint64_t total, std::string what);
  ~ProgressLine();  // clears the line
  ProgressLine(const ProgressLine&) = delete;
  ProgressLine& operator=(const ProgressLine&) = delete;

  // Draws the line for `done` finished runs.  Does nothing if the last drawing was less than 0.2 s
  // ago, because many short runs would draw more often than a person can read.
  void Show(uint64_t done);

 private:
  void Draw(uint64_t done);

  const int descriptor_;  // -1: no terminal
  const uint64_t total_;
  const std::string what_;
  const int64_t begin_ns_;
  int64_t drawn_ns_ = 0;
};

}  // namespace openr_host
