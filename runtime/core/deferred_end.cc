#include "runtime/core/deferred_end.h"

#include <signal.h>

#include "runtime/base/assert.h"

namespace openr_host {
namespace {

volatile sig_atomic_t g_depth = 0;
void (*volatile g_end)() = nullptr;

}  // namespace

DeferredEnd::DeferredEnd() { g_depth = g_depth + 1; }

DeferredEnd::~DeferredEnd() {
  ASSERT(g_depth > 0, "more destructors of DeferredEnd than constructors");
  g_depth = g_depth - 1;
  if (g_depth != 0 || g_end == nullptr) return;
  void (*const end)() = g_end;
  g_end = nullptr;
  end();
}

bool DeferredEnd::Defer(void (*end)()) {
  if (g_depth == 0) return false;
  g_end = end;
  return true;
}

}  // namespace openr_host
