// The fuzz target properties: property files.
#include <algorithm>
#include <bit>
#include <cstdint>
#include <stdexcept>

#include "openr/explore/property_file.h"
#include "runtime/base/hasher.h"
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
    // The operator, and the time in powers of two, because all operators and times take the same
    // branches.
    const auto bits = std::bit_width(static_cast<uint64_t>(std::max<int64_t>(rule.within_us, 0)));
    ReachFuzzState(HashBytes(rule.op.data(), rule.op.size()) + static_cast<uint64_t>(bits));
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
