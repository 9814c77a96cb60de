// ConsoleLog, which keeps the last lines that the objects of a run have printed.
#pragma once

#include <cstdint>
#include <deque>
#include <string>
#include <string_view>

namespace openr_host {

class ConsoleLog {
 public:
  struct Line {
    int64_t time_us;
    std::string text;
  };

  // The largest number of printed lines that a ConsoleLog keeps.
  static constexpr size_t kLinesMax = 1000;
  // The largest number of characters that a ConsoleLog keeps of a printed line.
  static constexpr size_t kLineMax = 2000;

  // Adds text that was printed at the virtual time `time_us`.  If the text ends in the middle of a
  // line, keeps this part of the line until the rest comes.
  void Add(int64_t time_us, std::string_view text);

  // Returns how many lines objects have printed since the start of the run.
  uint64_t count() const { return count_; }
  // Returns the last lines that objects have printed.  The newest line has the number count() - 1.
  const std::deque<Line>& lines() const { return lines_; }

 private:
  uint64_t count_ = 0;
  std::deque<Line> lines_;
  std::string begun_;  // the first part of a line that has no end yet
};

}  // namespace openr_host
