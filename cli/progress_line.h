// ProgressLine: a line on the terminal that shows the progress of a long command.
#pragma once

#include <cstdint>
#include <optional>
#include <string>

namespace openr_host {

// Returns the text of a progress line: "openr: 40 of 100 seeds, about 90 s left".  `what` is the
// plural noun for the things that are counted, such as "seeds".  At the beginning the remaining
// time is not known yet, and the text leaves it out.  Without a total the text is "openr: 40
// seeds".
std::string ProgressText(uint64_t done, std::optional<uint64_t> total, const std::string& what,
                         double elapsed_s);

// Returns the time before which a command shows no progress line: 2 s, or the number of
// milliseconds in the environment variable OPENR_HOST_PROGRESS_MS.
int64_t ProgressQuietNs();

// Draws the progress line on a terminal.  Each drawing replaces the previous one.  Writes nothing
// if `descriptor` is -1 or no terminal, and nothing before `quiet_ns` have passed.
class ProgressLine {
 public:
  // `total` is the number of pieces of work that the line counts; nullopt if this number is not
  // known.
  ProgressLine(int descriptor, std::optional<uint64_t> total, std::string what,
               int64_t quiet_ns = ProgressQuietNs());
  ~ProgressLine();  // clears the line
  ProgressLine(const ProgressLine&) = delete;
  ProgressLine& operator=(const ProgressLine&) = delete;

  // Draws the progress line for `done` finished pieces of work.  Does nothing if the last drawing
  // was less than 0.2 s ago, because many short pieces would draw more often than a person can
  // read.
  void Show(uint64_t done);

  // Returns whether the line can be drawn; false if the descriptor is -1 or no terminal.
  bool is_shown() const { return descriptor_ >= 0; }

 private:
  const int descriptor_;  // descriptor of the terminal; -1: the line is not drawn
  const std::optional<uint64_t> total_;
  const std::string what_;
  const int64_t begin_ns_;
  const int64_t quiet_ns_;
  int64_t drawn_ns_ = 0;
};

// A progress line of a run: counts the seconds of virtual time from `begin_us` to `end_us`.
class RunProgressLine {
 public:
  RunProgressLine(int descriptor, int64_t begin_us, int64_t end_us);

  // Draws the line for a run whose virtual time is `now_us`, as ProgressLine::Show() does.
  void Show(int64_t now_us);

 private:
  const int64_t begin_us_;
  ProgressLine line_;
};

// Clears the line that a ProgressLine of this process has drawn last, if the terminal still shows
// this line.  Must be called before other text is written to the terminal; the next Show() draws
// the line again.
void ClearProgressLine();

}  // namespace openr_host
