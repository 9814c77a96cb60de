#include "runtime/core/configured_cost.h"

#include "runtime/base/assert.h"
#include "runtime/core/object.h"

namespace openr_host {

ConfiguredCost::ConfiguredCost(CostConfig config, uint64_t seed)
    : config_(std::move(config)), used_(config_.rules.size(), false), rng_(seed, "cost") {}

ConfiguredCost::Cost ConfiguredCost::Find(const Object& object, uint32_t selector) {
  const std::string entry = object.EntryName(selector);
  Cost cost;
  // Goes through all rules of the cost file, also after a rule that fits the handler, because the
  // last rule that fits decides.  Marks all rules that fit as used, so that Unused() does not
  // report them.
  for (size_t i = 0; i < config_.rules.size(); ++i) {
    const CostRule& rule = config_.rules[i];
    if (!MatchesPattern(rule.object, object.name) || !MatchesPattern(rule.entry, entry)) continue;
    used_[i] = true;
    cost = {rule.cost_us, rule.cost_us * rule.jitter_percent / 100};
  }
  return cost;
}

std::vector<FilePosition> ConfiguredCost::Unused() const {
  std::vector<FilePosition> unused;
  for (size_t i = 0; i < used_.size(); ++i) {
    if (!used_[i]) unused.push_back(config_.rules[i].place);
  }
  return unused;
}

int64_t ConfiguredCost::CostUs(const Object& object, uint32_t selector) {
  const auto [known, is_new] = known_.try_emplace({object.id, selector});
  if (is_new) known->second = Find(object, selector);
  const Cost& cost = known->second;
  return cost.range_us == 0 ? cost.us : cost.us + JitterUs(object, selector, cost.range_us);
}

int64_t ConfiguredCost::JitterUs(const Object&, uint32_t, int64_t range_us) {
  ASSERT(range_us > 0, "jitter of {} us", range_us);
  return static_cast<int64_t>(rng_.NextBelow(static_cast<uint64_t>(2 * range_us + 1))) - range_us;
}

void ConfiguredCost::HashState(Hasher* hasher) const { rng_.HashState(hasher); }

}  // namespace openr_host
