// ProgressLine: a line on the terminal that shows the progress of a long command.
#pragma once

#include <cstdint>
#include <string>

namespace openr_host {

// Returns the text of the line: "openr: 40 of 100 seeds, about 90 s left".  `what` is the
// plural of what is counted, such as "seeds".  The time is left out at the beginning, when it is
// not known.
std::string ProgressText(uint64_t done, uint64_t total, const std::string& what, double elapsed_s);

// A command that takes less than this time shows no line.
inline constexpr int64_t kQuickNs = 2'000'000'000;

// Draws the line on a terminal; each drawing replaces the one before.  Writes nothing if
// `descriptor` is no terminal or -1, or before `quiet_ns` are over.
class ProgressLine {
 public:
  ProgressLine(int descriptor, uint64_t total, std::string what, int64_t quiet_ns = kQuickNs);
  ~ProgressLine();  // clears the line
  ProgressLine(const ProgressLine&) = delete;
  ProgressLine& operator=(const ProgressLine&) = delete;

  // Draws the line for `done` finished pieces.  Does nothing if the last drawing was less than 0.2
  // s ago, because many short pieces would draw more often than a person can read.
  void Show(uint64_t done);

  // Returns whether Show() may ever draw.
  bool is_shown() const { return descriptor_ >= 0; }

 private:
  const int descriptor_;  // -1: no terminal
  const uint64_t total_;
  const std::string what_;
  const int64_t begin_ns_;
  const int64_t quiet_ns_;
  int64_t drawn_ns_ = 0;
};

// Clears the line that a ProgressLine of this process has drawn last, if it is still there.  Must
// be called before other text is written to the terminal; the next Show() draws the line again.
void ClearProgressLine();

}  // namespace openr_host
