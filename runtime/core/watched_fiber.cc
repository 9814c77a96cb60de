// Tells ThreadSanitizer about switches between fibers.  This file itself is compiled without
// ThreadSanitizer.  Otherwise the compiler would add code to Enter() that records the call and the
// return of Enter().  Because Enter() switches fibers, ThreadSanitizer would record the call for
// one fiber and the return for another.
#include "runtime/core/watched_fiber.h"

#if defined(__SANITIZE_THREAD__)

#include <pthread.h>
#include <sanitizer/tsan_interface.h>

extern "C" {
// Functions of ThreadSanitizer that its header does not declare.  After a call of the first
// function, ThreadSanitizer ignores the memory accesses of the running fiber.  After a call of the
// second function, it ignores the locks of the running fiber.
void AnnotateIgnoreReadsBegin(const char* file, int line);
void AnnotateIgnoreSyncBegin(const char* file, int line);
}

namespace openr_host {
namespace {

int g_fibers = 0;  // number of ThreadSanitizer's fibers that WatchedFibers own
// True if this process was forked from a process that had fibers.  ThreadSanitizer takes fibers for
// threads, which fork() does not copy.  So in the new process ThreadSanitizer ignores the fiber
// that has called fork(), and the switches from it to other fibers.  Without these switches
// ThreadSanitizer would report races between the other fibers that do not exist.  Therefore Enter()
// makes ThreadSanitizer ignore all other fibers too.  No race is missed, because the new process
// has only one thread.
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
  // The argument 0 tells ThreadSanitizer that everything done on the stack that ran until now
  // happens before everything done on this stack from now on.  This is true, because all fibers
  // belong to one thread.
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
