// The costs of handlers, that is, their processor times, in a run of an exploration.  A cost file
// gives the costs; the schedule of the run chooses their jitter, the random part.
#pragma once

#include <utility>

#include "openr/explore/explore_schedule.h"
#include "runtime/core/configured_cost.h"

namespace openr_host {

class ExploredCost : public ConfiguredCost {
 public:
  explicit ExploredCost(CostConfig config) : ConfiguredCost(std::move(config), 1) {}

  // Sets the schedule of the run, which chooses by how much each handler's cost differs from the
  // cost file (the jitter).  Null means that there is no jitter.
  void set_schedule(ExploreSchedule* schedule) { schedule_ = schedule; }

 protected:
  int64_t JitterUs(const Object& object, uint32_t selector, int64_t range_us) override {
    return schedule_ == nullptr ? 0 : schedule_->CostJitterUs(object, selector, range_us);
  }

 private:
  ExploreSchedule* schedule_ = nullptr;
};

}  // namespace openr_host
