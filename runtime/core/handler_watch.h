// Watches a handler of an image while it runs: how much stack its own functions use, and where its
// arithmetic goes wrong.
//
// Functions of the SDK and of the C library run on the same stack, but their frames are those of
// this host and say nothing about the robot.  So every call of them is announced (ApiScope,
// LibraryScope), and what lies below the caller's frame during the call does not count.  Nor does
// their arithmetic.
#pragma once

#include <cstddef>
#include <cstdint>

namespace openr_host {

class HandlerWatch {
 public:
  // How deep a stack is watched, for an object whose .ocf file gives it `stack_bytes`: enough to
  // tell whether a handler needs twice as much.
  static size_t DepthFor(size_t stack_bytes);

  // False with AddressSanitizer and under Valgrind, which watch unused stack themselves.
  static bool CanMeasure();

  // Whether somebody in this process handles SIGFPE of objects (CrashLog), so that arithmetic may
  // raise it; at first nobody does.
  static void SetCatchesNumbers(bool on);
  static bool CatchesNumbers();

  // `depth`: bytes of stack that are watched; 0: the stack is not measured.
  explicit HandlerWatch(size_t depth) : depth_(depth) {}

  // Code of the image begins to run below `base`, an address on the running stack.  Operations that
  // raise one of `kinds`, which are FpFlags, are SIGFPE.
  void Begin(void* base, unsigned kinds);

  // Operations that raise `kind` go on as usual; from the signal handler, which sees to the code
  // that was interrupted itself.
  void GiveUpCatching(unsigned kind) { kinds_ &= ~kind; }

  // Code of the image calls a function that is not its own, with the frame address `frame`; and
  // goes on.  Calls within calls are counted.
  void Enter(void* frame);
  void Leave();

  // How many bytes of stack it has used so far at most; `depth` stands for at least that many.
  // Functions that went less than about 300 bytes deeper than the last call of Enter() may be
  // missed.
  size_t Used();

  // The handler has ended.
  void End();

  bool has_begun() const { return base_ != nullptr; }

 private:
  const size_t depth_;
  unsigned kinds_ = 0;             // that are SIGFPE
  int calls_ = 0;                  // under way, of functions that are not the image's
  char* base_ = nullptr;           // where the handler's frames begin
  char* bottom_ = nullptr;         // end of the stack that is watched
  char* low_ = nullptr;            // lowest address that the handler is known to have used
  uint64_t* clean_end_ = nullptr;  // from bottom_ to here the stack was painted last
  unsigned saved_fp_ = 0;          // MXCSR of the image during a call
};

}  // namespace openr_host
