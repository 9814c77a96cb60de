// The fuzz target emon_log: crash records of robots (EMON.LOG).
#include "openr/emon/emon_log.h"

#include "openr/emon/emon_text.h"
#include "tests/fuzz/fuzz_targets.h"
#include "tests/fuzz/target_list.h"

namespace openr_host {

bool fuzz::emon_log(std::string_view bytes) {
  const std::optional<EmonLog> log = ParseEmonLog(std::string(bytes));
  if (!log) return false;
  FuzzCheck(log->stack.size() <= size_t{1} << 18, "a stack of that size");
  const std::string text = ExplanationText(ExplainCrash(*log, nullptr));
  FuzzCheck(text.starts_with("EXCEPTION ") == log->code.has_value(), "a code, and its meaning");
  return log->CrashedObject() != nullptr && log->code > 9u && log->registers[kRobotGp].has_value();
}

}  // namespace openr_host
