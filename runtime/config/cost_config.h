// A cost file: how long the robot's processor takes for handlers.
//
//   # OBJECT     ENTRY                                   MICROSECONDS [+-JITTER%]
//   *            *                                       50
//   JointMover   JointMover.Move.OCommandVectorData.S (Ready)  4050 +-53%
//   JointMover   DoStart                                 20000
//   frame 8021
//
// OBJECT and ENTRY are what traces show (Object::EntryName); '*' stands for any text.  The last
// line that fits a handler holds, so general lines come first; a handler that none fits costs
// nothing.  `frame` says how long a frame of the robot's devices, nominally 8 ms, lasts by the
// clock that programs read.  '#' as the first character makes a line a comment.
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
  int jitter_percent = 0;  // 0..100 of cost_us, to both sides
};

struct CostConfig {
  std::vector<CostRule> rules;  // in order of the file
  int64_t frame_us = 8000;
};

struct CostResult {
  CostConfig config;
  std::vector<Diagnostic> diagnostics;
};

// A bad line is reported and skipped.
CostResult ParseCostConfig(const std::string& file, std::string_view text);

// Whether `text` is what `pattern` says, '*' in it being any text, also none.
bool MatchesPattern(std::string_view pattern, std::string_view text);

}  // namespace openr_host
