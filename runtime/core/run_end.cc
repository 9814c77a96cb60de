#include "runtime/core/run_end.h"

#include <fmt/format.h>

namespace openr_host {

const char* EndName(EndKind kind) {
  constexpr const char* kNames[kEndKinds] = {
      "time",  "idle",          "pause",        "battery", "power-off", "fatal", "strict",
      "crash", "handler-limit", "lost-process", "no-boot", "signal",    "branch"};
  return kNames[static_cast<size_t>(kind)];
}

std::string DescribeEnd(const RunEnd& end) {
  return fmt::format("ended by {}: {}", EndName(end.kind), end.why);
}

}  // namespace openr_host
