// WatchedFiber: announces a fiber (fiber.h) to ThreadSanitizer.
//
// ThreadSanitizer keeps a list of the calls that have not returned yet, one list for each thread.
// Code that moves to another stack must have another list, or the returns on one stack end the
// calls of the other.  ThreadSanitizer calls such a list, with what it knows of the accesses that
// were made, a fiber.
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

  // Begins a new list of calls, for a stack that is empty.  Forgets the calls that were made on the
  // stack before and that never returned.  REQUIRES: the stack is not running.
  void Begin();

  // Notes which fiber of ThreadSanitizer runs on the stack that is about to be left.
  void Leave();

  // Tells ThreadSanitizer that this stack runs from now on.  The caller must change the stack
  // before it calls any other function or returns.
  void Enter();

 private:
  void Destroy();

  void* fiber_ = nullptr;
  bool is_ours_ = false;  // false: the fiber is that of the thread itself, which is not destroyed
  bool is_ignored_ = false;  // true: ThreadSanitizer does not watch the code of this fiber any more
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
