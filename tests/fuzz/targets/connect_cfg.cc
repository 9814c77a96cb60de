// The fuzz target connect_cfg: CONNECT.CFG.
#include "runtime/config/connect_config.h"
#include "tests/fuzz/fuzz_targets.h"
#include "tests/fuzz/target_list.h"

namespace openr_host {

bool fuzz::connect_cfg(std::string_view bytes) {
  const ConnectConfig result = ParseConnectConfig("CONNECT.CFG", bytes, "ERS-210");
  Render(result.diagnostics);
  int short_names = 0;
  for (const ConnectRecord& record : result.connections) {
    FuzzCheck(record.subject.is_subject() && !record.observer.is_subject(), "directions");
    FuzzCheck(ParseServiceName(Compose(record.subject), nullptr) == record.subject, "a name");
    short_names += record.subject.data.size() == 1;
  }
  return short_names > 0 && HasErrors(result.diagnostics);
}

}  // namespace openr_host
