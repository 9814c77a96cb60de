// The fuzz target csv_table: comma-separated values for openr plot.
#include <algorithm>
#include <stdexcept>
#include <string>

#include "openr/data/table.h"
#include "tests/fuzz/fuzz_targets.h"
#include "tests/fuzz/table_checks.h"
#include "tests/fuzz/target_list.h"

namespace openr_host {

bool fuzz::csv_table(std::string_view bytes) {
  bool has_found = false;
  try {
    const Table table = ReadCsvTable("table.csv", bytes);
    DrawFuzzedTable(table);
    for (const Series& series : table.series) {
      if (series.name.find(',') == std::string::npos) continue;
      const size_t values = series.values.size();
      const double third = values > 2 ? series.values[2] : 0;
      // All numbers of values, and all values, have the same branches.
      ReachFuzzState(2 * std::min<size_t>(values, 9) + (third > 7 ? 1 : 0));
      has_found |= third > 70;
    }
  } catch (const std::runtime_error&) {
  }
  return has_found;
}

}  // namespace openr_host
