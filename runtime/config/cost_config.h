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
#include <map>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "runtime/config/diagnostic.h"
#include "runtime/core/cpu.h"
#include "runtime/core/rng.h"

namespace openr_host {

struct CostRule {
  Place place;
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

// Charges what the file says.  Jitter is uniform, drawn from the generator "cost" of the seed.
class ConfiguredCost : public CostModel {
 public:
  ConfiguredCost(CostConfig config, uint64_t seed);

  int64_t CostUs(const Object& object, uint32_t selector) override;
  int64_t FrameUs() const override { return config_.frame_us; }
  void HashState(Hasher* hasher) const override;

  // Lines that fit no handler called so far.  One that another line below stands in for fits.
  std::vector<Place> Unused() const;

 protected:
  // What this call takes more, or less if negative: at most `range_us` > 0 to both sides.
  virtual int64_t JitterUs(const Object& object, uint32_t selector, int64_t range_us);

 private:
  struct Cost {
    int64_t us = 0;
    int64_t range_us = 0;
  };
  Cost Find(const Object& object, uint32_t selector);

  const CostConfig config_;
  std::vector<bool> used_;  // by rule
  Rng rng_;
  // Entries have their names by the time they are called first.
  std::map<std::pair<ObjectId, uint32_t>, Cost> known_;
};

}  // namespace openr_host
