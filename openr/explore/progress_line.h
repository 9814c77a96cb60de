// A line on the terminal that shows the progress of an exploration.
#pragma once

#include <cstdint>
#include <string>

namespace openr_host {

// Returns "openr explore: 40 of 100 seeds, about 90 s left".  `what` is the plural of what is
// counted.  The time is left out at the beginning, when it is not known.
std::string ProgressText(uint64_t done, uint64_t total, const std::string& what, double elapsed_s);

// Draws the line repeatedly in one place.  Writes nothing if `descriptor` is no terminal.
class ProgressLine {
 public:
  ProgressLine(int descriptor, uint64_t total, std::string what);
  ~ProgressLine();  // clears the line
  ProgressLine(const ProgressLine&) = delete;
  ProgressLine& operator=(const ProgressLine&) = delete;

  // Draws the line unless it was drawn a moment ago.
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
