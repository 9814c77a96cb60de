// A cost file says how long each handler takes on the robot's processor, so that the run charges
// this virtual time for the handler.
//
//   # OBJECT     ENTRY                                   MICROSECONDS [+-JITTER%]
//   *            *                                       50
//   JointMover   JointMover.Move.OCommandVectorData.S (Ready)  4050 +-53%
//   JointMover   DoStart                                 20000
//   frame 8021
//
// OBJECT and ENTRY are the names that traces show (Object::EntryName); '*' stands for any text.
// The last line that matches a handler decides, so general lines come first.  A handler without a
// matching line takes no time.  With a jitter, the time varies at random by up to this percentage,
// up or down.  The line "frame 8021" says that a frame of the robot's devices, nominally 8000 us,
// lasts 8021 us of the clock that programs read.  A line that begins with '#' is a comment.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "runtime/config/diagnostic.h"

namespace openr_host {

struct CostRule {
  FilePosition place;
  std::string object;
  std::string entry;
  int64_t cost_us = 0;
  // The virtual time that the handler takes varies at random by up to this percentage of cost_us (0
  // to 100), up or down.
  int jitter_percent = 0;
};

struct CostConfig {
  std::vector<CostRule> rules;  // in the order of the file
  int64_t frame_us = 8000;
};

struct CostResult {
  CostConfig config;
  std::vector<Diagnostic> diagnostics;
};

// Parses the text of a cost file, which says how much virtual time each handler takes.  A bad line
// is reported and skipped.
CostResult ParseCostConfig(const std::string& file, std::string_view text);

// Returns whether `text` matches `pattern`, in which '*' stands for any text, even for none.
bool MatchesPattern(std::string_view pattern, std::string_view text);

}  // namespace openr_host
