// The fuzz target designdb_cfg: DESIGNDB.CFG and DESIGN.CFG.
#include "runtime/config/design_config.h"
#include "tests/fuzz/fuzz_targets.h"
#include "tests/fuzz/target_list.h"

namespace openr_host {

bool fuzz::designdb_cfg(std::string_view bytes) {
  const DesignConfig result = ParseDesignConfig("DESIGNDB.CFG", bytes, "ERS-210");
  Render(result.diagnostics);
  bool is_short = false;
  for (const DesignRecord& record : result.designs) {
    FuzzCheck(record.path.find("/../") == std::string::npos, "a path leaves the stick");
    is_short |= record.keyword.size() == 1;
  }
  return is_short && HasErrors(result.diagnostics);
}

}  // namespace openr_host
