// Finds where the arithmetic of a handler goes wrong: operations that make NaN, infinity or a
// denormal number raise SIGFPE while the handler's own code runs.
//
// Functions of the SDK and of the C library are not the object's own.  Every call of them that
// this library can see is announced (ApiScope, LibraryScope), and raises nothing.
#pragma once

namespace openr_host {

class ArithmeticWatch {
 public:
  // Whether somebody in this process handles SIGFPE of objects (CrashLog), so that arithmetic may
  // raise it; at first nobody does.  Never with AddressSanitizer or under Valgrind, whose processor
  // raises no SIGFPE.
  static void SetCatches(bool on);
  static bool Catches();

  // Operations of the handler, which begins, that raise one of `kinds` (FpFlags) are SIGFPE.
  void Begin(unsigned kinds);
  bool has_begun() const { return has_begun_; }

  // Operations that raise `kind` go on as usual; from the signal handler, which sees to the code
  // that was interrupted itself.
  void GiveUpCatching(unsigned kind) { kinds_ &= ~kind; }

  // Code of the image calls a function that is not its own; and goes on.  Calls within calls are
  // counted.
  void Enter();
  void Leave();

  // The handler has ended.
  void End();

 private:
  bool has_begun_ = false;
  unsigned kinds_ = 0;     // that are SIGFPE
  int calls_ = 0;          // under way, of functions that are not the image's
  unsigned saved_fp_ = 0;  // MXCSR of the image during a call
};

}  // namespace openr_host
