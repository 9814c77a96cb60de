// WatchedFiber: announces a fiber (fiber.h) to ThreadSanitizer.
//
// ThreadSanitizer keeps a list of the calls that have not returned yet, one list for each thread.
// Code that moves to another stack must have another list, or the returns on one stack end the
// calls of the other.  ThreadSanitizer calls such a list, with the accesses that it belongs to, a
// fiber.
//
// In a build without ThreadSanitizer the class has no members, and its functions do nothing.
#pragma once

#if defined(__SANITIZE_THREAD__)
#include <sanitizer/tsan_interface.h>
#endif

namespace openr_host {

#if defined(__SANITIZE_THREAD__)

class WatchedFiber {
 public:
  WatchedFiber() = default;
  ~WatchedFiber() { Destroy(); }
  WatchedFiber(const WatchedFiber&) = delete;
  WatchedFiber& operator=(const WatchedFiber&) = delete;

  // Begins a new list of calls, for a stack that is empty.  Forgets the calls that were made on the
  // stack before and that never returned.  REQUIRES: the stack is not running.
  void Begin() {
    Destroy();
    fiber_ = __tsan_create_fiber(0);
    is_ours_ = true;
  }

  // Notes which fiber of ThreadSanitizer runs on the stack that is about to be left.
  void Leave() {
    if (!is_ours_) fiber_ = __tsan_get_current_fiber();
  }

  // Tells ThreadSanitizer that this stack runs from now on.  The caller must change the stack
  // before any other function is called or returns.  The argument 0 says that what was done on the
  // stack that is left happens before what is done on this stack, as in one thread.
  [[gnu::always_inline]] void Enter() const { __tsan_switch_to_fiber(fiber_, 0); }

 private:
  void Destroy() {
    if (is_ours_) __tsan_destroy_fiber(fiber_);
    is_ours_ = false;
  }

  void* fiber_ = nullptr;
  bool is_ours_ = false;  // false: the fiber is that of the thread itself, which is not destroyed
};

#else

class WatchedFiber {
 public:
  void Begin() {}
  void Leave() {}
  void Enter() const {}
};

#endif

}  // namespace openr_host
