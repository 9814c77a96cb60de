// DeferredEnd: marks a section of code in which a signal handler must not end the process.
//
// The code in the section may hold a lock that is also needed to end the process.  If a signal
// handler ended the process in the middle of the section, the signal handler would wait for this
// lock for ever.
#pragma once

namespace openr_host {

// While a DeferredEnd exists, a signal handler that wants to end the process does not do so at
// once.  The destructor of the outermost DeferredEnd then ends the process.  Used only in the
// thread that runs handlers.
class DeferredEnd {
 public:
  DeferredEnd();
  ~DeferredEnd();  // does not return if the destructor ends the process
  DeferredEnd(const DeferredEnd&) = delete;
  DeferredEnd& operator=(const DeferredEnd&) = delete;

  // Called in a signal handler that wants to end the process by calling `end`.  If the signal has
  // interrupted a section of code that a DeferredEnd marks, returns true: the destructor of this
  // DeferredEnd will call `end`.  Otherwise returns false: the signal handler may end the process
  // itself.  Only for signals of the thread that runs handlers.
  static bool Defer(void (*end)());
};

}  // namespace openr_host
