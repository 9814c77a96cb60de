// The fuzz target ocf: .ocf files.
#include "runtime/config/ocf.h"

#include "tests/fuzz/fuzz_targets.h"
#include "tests/fuzz/target_list.h"

namespace openr_host {

bool fuzz::ocf(std::string_view bytes) {
  const OcfResult result = ParseOcf("object.ocf", bytes);
  Render(result.diagnostics);
  FuzzCheck(result.ocf.has_value() != HasErrors(result.diagnostics), "an error or a description");
  if (!result.ocf) return false;
  FuzzCheck(result.ocf->priority >= 0 && result.ocf->priority <= 255, "a priority");
  FuzzCheck(result.ocf->stack_bytes >= 0 && result.ocf->heap_bytes >= 0, "a size");
  return result.ocf->priority > 200 || !result.ocf->is_user_mode;
}

}  // namespace openr_host
