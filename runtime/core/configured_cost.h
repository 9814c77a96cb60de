// The cost model that a cost file describes.
#pragma once

#include <cstdint>
#include <map>
#include <utility>
#include <vector>

#include "runtime/base/rng.h"
#include "runtime/config/cost_config.h"
#include "runtime/core/cpu.h"

namespace openr_host {

// Charges what the file says.  Jitter is uniform, drawn from the generator "cost" of the seed.
class ConfiguredCost : public CostModel {
 public:
  ConfiguredCost(CostConfig config, uint64_t seed);

  int64_t CostUs(const Object& object, uint32_t selector) override;
  int64_t FrameUs() const override { return config_.frame_us; }
  void HashState(Hasher* hasher) const override;

  // Lines that fit no handler called so far.  One that another line below stands in for fits.
  std::vector<FilePosition> Unused() const;

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
