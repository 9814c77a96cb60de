// The fuzz target placement: placement files.
#include "distribution/placement.h"

#include "tests/fuzz/fuzz_targets.h"
#include "tests/fuzz/target_list.h"

namespace openr_host {

bool fuzz::placement(std::string_view bytes) {
  std::vector<Diagnostic> diagnostics;
  Placement placement = ParsePlacement("placement", bytes, &diagnostics);
  Render(diagnostics);
  for (const auto& [object, process] : placement.process_of) {
    FuzzCheck(NameProblem("process", process).empty(), "the name of a process");
  }
  AddPlace(std::string(bytes.substr(0, bytes.find('\n'))), &placement);
  return placement.host_of.size() == 2 && placement.process_of.size() > 2;
}

}  // namespace openr_host
