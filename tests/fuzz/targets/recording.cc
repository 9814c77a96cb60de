// The fuzz target recording: recordings of runs.
#include <stdexcept>

#include "openr/inspect/trace_file.h"
#include "runtime/base/hasher.h"
#include "tests/fuzz/fuzz_targets.h"
#include "tests/fuzz/target_list.h"

namespace openr_host {

bool fuzz::recording(std::string_view bytes) {
  // Reads the file as it is, and once more the entries alone, because hardly any random block has
  // the right checksum.
  const FuzzFile file(bytes);
  try {
    TraceReader reader(file.path());
    while (reader.Peek() != nullptr) reader.Take();
    reader.NoMatchText("JointMover", "Move");
  } catch (const std::runtime_error&) {
  }
  bool has_network = false;
  for (const bool payloads : {true, false}) {
    try {
      TraceCoder coder(payloads);
      ByteReader in(bytes);
      while (!in.AtEnd()) {
        const TraceEntry entry = coder.Read(&in);
        has_network |= entry.kind == TraceEntry::Kind::kNetwork && entry.events.size() != 2 &&
                       !entry.events.empty();
      }
    } catch (const std::runtime_error&) {
    }
  }
  return has_network;
}

}  // namespace openr_host
