// ConfiguredCost: gives each handler the processor time that a cost file sets for it.
#pragma once

#include <cstdint>
#include <map>
#include <utility>
#include <vector>

#include "runtime/base/rng.h"
#include "runtime/config/cost_config.h"
#include "runtime/core/cpu.h"

namespace openr_host {

// Takes the cost of each handler from the rules of a cost file.  The cost varies by a random
// jitter, which is uniform.  The jitter has a random generator of its own, so it does not change
// other random numbers of the run.
class ConfiguredCost : public CostModel {
 public:
  ConfiguredCost(CostConfig config, uint64_t seed);

  int64_t CostUs(const Object& object, uint32_t selector) override;
  int64_t FrameUs() const override { return config_.frame_us; }
  void HashState(Hasher* hasher) const override;

  // Returns the places in the cost file of the rules that have matched no handler so far, which are
  // probably mistakes.  A rule that has matched a handler is left out, even if a later rule has
  // overridden it.
  std::vector<FilePosition> Unused() const;

 protected:
  // Returns the jitter, the random part of the cost of this call: a number from -range_us to
  // range_us that is added to the cost in the cost file.  Virtual because the exploration of
  // schedules chooses the jitter itself (openr/explore/explore_cost.h).  REQUIRES: range_us > 0.
  virtual int64_t JitterUs(const Object& object, uint32_t selector, int64_t range_us);

 private:
  struct Cost {
    int64_t us = 0;
    int64_t range_us = 0;
  };
  Cost Find(const Object& object, uint32_t selector);

  const CostConfig config_;
  std::vector<bool> used_;  // for each rule: whether its patterns have matched a handler
  Rng rng_;
  // The costs that ConfiguredCost::Find() has found, by object and selector, so that the rules of
  // the cost file are searched only at the first call of an entry.  A cost stays valid, because an
  // entry does not change its name after its first call.
  std::map<std::pair<ObjectId, uint32_t>, Cost> known_;
};

}  // namespace openr_host
