// WatchedFiber: announces a fiber (a stack on which handlers run, fiber.h) to ThreadSanitizer.
//
// ThreadSanitizer keeps a list of the calls that have not returned yet.  Each stack needs a list of
// its own, because in a common list a return on one stack would end a call on another stack.
// ThreadSanitizer keeps this list, and what it knows of the memory accesses, in an object that it
// also calls a fiber.
//
// In a build without ThreadSanitizer the class has no members, and its functions do nothing.
#pragma once

namespace openr_host {

#if defined(__SANITIZE_THREAD__)

class WatchedFiber {
 public:
  WatchedFiber();
  ~WatchedFiber();
  WatchedFiber(const WatchedFiber&) = delete;
  WatchedFiber& operator=(const WatchedFiber&) = delete;

  // Begins a new list of calls in ThreadSanitizer, for a stack that is empty.  Drops the old list,
  // with the calls on this stack that never returned.  REQUIRES: the stack is not running.
  void Begin();

  // Called before the running stack is left.  Stores in fiber_ ThreadSanitizer's object for this
  // stack, which ThreadSanitizer calls a fiber.
  void Leave();

  // Tells ThreadSanitizer that this stack runs from now on.  The caller must change the stack
  // before it calls any other function or returns.
  void Enter();

 private:
  void Destroy();

  void* fiber_ = nullptr;
  bool is_ours_ = false;     // false: fiber_ belongs to the thread itself and must not be destroyed
  bool is_ignored_ = false;  // true: ThreadSanitizer ignores the code that runs on this fiber
};

#else

class WatchedFiber {
 public:
  void Begin() {}
  void Leave() {}
  void Enter() {}
};

#endif

}  // namespace openr_host
