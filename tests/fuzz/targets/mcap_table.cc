// The fuzz target mcap_table: MCAP files for openr plot.
#include <algorithm>
#include <stdexcept>
#include <string_view>

#include "openr/data/mcap_writer.h"
#include "openr/data/table.h"
#include "tests/fuzz/fuzz_targets.h"
#include "tests/fuzz/table_checks.h"
#include "tests/fuzz/target_list.h"

namespace openr_host {

bool fuzz::mcap_table(std::string_view bytes) {
  if (bytes.starts_with(kMcapMagic)) {
    FuzzBytes input(bytes);
    input.Text(kMcapMagic.size());
    // A step is a record, or the begin of a chunk, whose records are steps of their own.
    while (!input.empty()) {
      BeginFuzzStep(input.taken());
      const auto op = static_cast<McapOp>(input.U8());
      const uint64_t size = input.U64();
      constexpr size_t kChunkBegin = 8 + 8 + 8 + 4 + 4 + 8;  // a chunk without compression
      input.Text(op == McapOp::kChunk ? kChunkBegin : size);
    }
  }
  bool has_found = false;
  try {
    const Table table = ReadMcapTable("table.mcap", bytes);
    DrawFuzzedTable(table);
    for (const Series& series : table.series) {
      constexpr std::string_view kBegin = "robots[";
      if (!series.name.starts_with(kBegin)) continue;
      const size_t values = series.values.size();
      const bool is_first = series.name[kBegin.size()] <= '1';
      // All numbers of robots and of values have the same branches.
      ReachFuzzState(2 * std::min<size_t>(values, 9) + (is_first ? 0 : 1));
      has_found |= !is_first && values > 2;
    }
  } catch (const std::runtime_error&) {
  }
  return has_found;
}

}  // namespace openr_host
