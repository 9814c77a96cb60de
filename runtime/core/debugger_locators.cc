#include "runtime/core/debugger_locators.h"

#include <algorithm>

#include "runtime/base/assert.h"

// The text that SetLocatorsForDebugger() has set: a line with number and locator of each primitive,
// and a zero byte after the last line.  The variable has a C name, so that gdb finds it without
// debug information.
extern "C" {
[[gnu::visibility("default"), gnu::used]] char openr_locators[16 * 1024];
}

namespace openr_host {

void SetLocatorsForDebugger(const std::string& lines) {
  ASSERT(lines.size() < sizeof openr_locators, "{} bytes", lines.size());
  *std::copy(lines.begin(), lines.end(), openr_locators) = '\0';
}

}  // namespace openr_host
