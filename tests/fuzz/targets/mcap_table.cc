// The fuzz target mcap_table: MCAP files for openr plot.
#include <stdexcept>

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
      constexpr size_t kChunkBegin = 8 + 8 + 8 + 4 + 4 + 8;  // of a chunk without compression
      input.Text(op == McapOp::kChunk ? kChunkBegin : size);
    }
  }
  bool has_found = false;
  try {
    const Table table = ReadMcapTable("table.mcap", bytes);
    DrawFuzzedTable(table);
    for (const Series& series : table.series) {
      has_found |=
          series.name.starts_with("robots[") && series.name[7] > '1' && series.values.size() > 2;
    }
  } catch (const std::runtime_error&) {
  }
  return has_found;
}

}  // namespace openr_host
