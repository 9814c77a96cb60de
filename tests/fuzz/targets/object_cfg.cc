// The fuzz target object_cfg: OBJECT.CFG.
#include "runtime/config/object_config.h"
#include "tests/fuzz/fuzz_targets.h"
#include "tests/fuzz/target_list.h"

namespace openr_host {

bool fuzz::object_cfg(std::string_view bytes) {
  const ObjectConfig result = ParseObjectConfig("OBJECT.CFG", bytes, "ERS-210");
  Render(result.diagnostics);
  for (const ObjectRecord& record : result.objects) {
    FuzzCheck(record.path.find("..") == std::string::npos ||
                  record.path.find("/../") == std::string::npos,
              "a path leaves the stick");
    if (record.section == "ERS-210" && result.objects.size() > 2) return true;
  }
  return false;
}

}  // namespace openr_host
