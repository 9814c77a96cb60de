// The fuzz target aibo_log: logs of motions (AIBO_1.1).
#include <stdexcept>

#include "openr/motion/log_file.h"
#include "tests/fuzz/fuzz_targets.h"
#include "tests/fuzz/target_list.h"

namespace openr_host {

bool fuzz::aibo_log(std::string_view bytes) {
  try {
    const LogFile log = ParseLog(std::string(bytes));
    FuzzCheck(FormatLog(log) == bytes, "a log is written as it was read");
    return log.records.size() == 1 && log.records[0].simulated && log.records[0].key_frame > 256;
  } catch (const std::runtime_error&) {
    return false;
  }
}

}  // namespace openr_host
