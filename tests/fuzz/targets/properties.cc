// The fuzz target properties: property files.
#include <stdexcept>

#include "openr/explore/property_file.h"
#include "tests/fuzz/fuzz_targets.h"
#include "tests/fuzz/target_list.h"

namespace openr_host {

bool fuzz::properties(std::string_view bytes) {
  std::vector<Diagnostic> diagnostics;
  bool is_deep = false;
  for (const PropertyRule& rule : ParseProperties("properties", bytes, &diagnostics)) {
    try {
      Compares(1.5, rule.op, rule.value);
      Compares(std::string("finished"), rule.op, rule.value);
    } catch (const std::runtime_error&) {
    }
    is_deep |= rule.within_us > 30'000'000 && rule.op == "!=";
  }
  Render(diagnostics);
  try {
    MakeProperties("properties", bytes);
  } catch (const std::runtime_error&) {
  }
  return is_deep;
}

}  // namespace openr_host
