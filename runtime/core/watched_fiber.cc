// This file is compiled without ThreadSanitizer, whose notes of calls and returns would go to two
// fibers in a function that switches from one fiber to the other.
#include "runtime/core/watched_fiber.h"

#if defined(__SANITIZE_THREAD__)

#include <pthread.h>
#include <sanitizer/tsan_interface.h>

extern "C" {
// Functions of ThreadSanitizer that its header does not declare.  From their call on, it ignores
// the accesses and the locks of the fiber that runs.
void AnnotateIgnoreReadsBegin(const char* file, int line);
void AnnotateIgnoreSyncBegin(const char* file, int line);
}

namespace openr_host {
namespace {

int g_fibers = 0;  // number of WatchedFibers that have a fiber of their own
// Whether this process is a copy, made by fork(), of a process that had fibers.  ThreadSanitizer
// takes these for threads that were lost in the copy, and ignores the fiber that has called fork()
// from then on.  The others must be ignored as well: otherwise the accesses of one half of the
// fibers would look as if nothing had put them in order.  Nothing is missed, because such a copy
// has one thread.
bool g_is_copy = false;

void NoteCopy() { g_is_copy = g_is_copy || g_fibers > 0; }

}  // namespace

WatchedFiber::WatchedFiber() {
  [[maybe_unused]] static const int registered = pthread_atfork(nullptr, nullptr, &NoteCopy);
}

WatchedFiber::~WatchedFiber() { Destroy(); }

void WatchedFiber::Begin() {
  Destroy();
  fiber_ = __tsan_create_fiber(0);
  is_ours_ = true;
  __atomic_add_fetch(&g_fibers, 1, __ATOMIC_RELAXED);
}

void WatchedFiber::Leave() {
  if (!is_ours_) fiber_ = __tsan_get_current_fiber();
}

void WatchedFiber::Enter() {
  // The argument 0 says that what was done on the stack that is left happens before what is done on
  // this stack, as in one thread.
  __tsan_switch_to_fiber(fiber_, 0);
  if (!g_is_copy || is_ignored_) return;
  AnnotateIgnoreReadsBegin(__FILE__, __LINE__);
  AnnotateIgnoreSyncBegin(__FILE__, __LINE__);
  is_ignored_ = true;
}

void WatchedFiber::Destroy() {
  if (!is_ours_) return;
  __tsan_destroy_fiber(fiber_);
  is_ours_ = is_ignored_ = false;
  __atomic_sub_fetch(&g_fibers, 1, __ATOMIC_RELAXED);
}

}  // namespace openr_host

#endif
