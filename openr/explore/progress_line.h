// The line that tells a person on a terminal how far an exploration is.
#pragma once

#include <cstdint>
#include <string>

namespace openr_host {

// "openr explore: 40 of 100 seeds, about 90 s left".  `what` is the plural of what is counted.  The
// time is left out while nothing is done, since nobody knows it then.
std::string ProgressText(uint64_t done, uint64_t total, const std::string& what, double elapsed_s);

// Draws the line again and again in one place.  Writes nothing when `descriptor` is no terminal.
class ProgressLine {
 public:
  ProgressLine(int descriptor, uint64_t total, std::string what);
  ~ProgressLine();  // wipes the line
  ProgressLine(const ProgressLine&) = delete;
  ProgressLine& operator=(const ProgressLine&) = delete;

  // Draws the line unless it was drawn a moment ago.
  void Show(uint64_t done);

 private:
  void Draw(uint64_t done);

  const int descriptor_;  // -1: there is no terminal
  const uint64_t total_;
  const std::string what_;
  const int64_t begin_ns_;
  int64_t drawn_ns_ = 0;
};

}  // namespace openr_host
