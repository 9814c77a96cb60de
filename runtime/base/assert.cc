#include "runtime/base/assert.h"

#include <cstdio>
#include <cstdlib>

namespace openr_host {

std::string (*assert_context)() = nullptr;

void AssertFailed(const char* file, int line, const char* condition, const std::string& details) {
  std::fflush(stdout);
  const std::string context = assert_context == nullptr ? "" : assert_context();
  std::fprintf(stderr, "%s:%d: ASSERT(%s) failed%s%s\n%s", file, line, condition,
               details.empty() ? "" : ": ", details.c_str(), context.c_str());
  std::abort();
}

}  // namespace openr_host
