// The fuzz target stub_cfg: stub.cfg, and the stub made from it.
#include "runtime/config/stub_config.h"
#include "runtime/config/stub_generator.h"
#include "tests/fuzz/fuzz_targets.h"
#include "tests/fuzz/target_list.h"

namespace openr_host {

bool fuzz::stub_cfg(std::string_view bytes) {
  const StubConfigResult result = ParseStubConfig("stub.cfg", bytes);
  Render(result.diagnostics);
  if (HasErrors(result.diagnostics)) return false;
  FuzzCheck(GenerateStub(result.config, "stub.cfg").size() == 4, "four files");
  return result.config.extras.size() > 1 && result.config.object_name.size() < 3;
}

}  // namespace openr_host
