// The fuzz target cost: cost files.
#include "runtime/config/cost_config.h"
#include "tests/fuzz/fuzz_targets.h"
#include "tests/fuzz/target_list.h"

namespace openr_host {

bool fuzz::cost(std::string_view bytes) {
  const CostResult result = ParseCostConfig("ers210.cost", bytes);
  Render(result.diagnostics);
  FuzzCheck(result.config.frame_us > 0, "the length of a frame");
  for (const CostRule& rule : result.config.rules) {
    FuzzCheck(rule.cost_us >= 0 && rule.jitter_percent >= 0 && rule.jitter_percent <= 100,
              "a cost");
    MatchesPattern(rule.object, "JointMover");
    MatchesPattern(rule.entry, "JointMover.Move.OCommandVectorData.S (Ready)");
    if (rule.jitter_percent == 99) return true;
  }
  return false;
}

}  // namespace openr_host
