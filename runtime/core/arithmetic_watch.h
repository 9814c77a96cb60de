// Finds the instruction of a handler that makes a NaN or an infinity, or uses a denormal number:
// such operations raise SIGFPE while the handler's own code runs.
//
// Functions of the SDK and of the C library are not the handler's own code, so their operations
// raise nothing.  ApiScope and LibraryScope (current.h) tell the watch when such a call begins and
// ends.
#pragma once

namespace openr_host {

class ArithmeticWatch {
 public:
  // Says whether this process has a handler for SIGFPE (CrashLog); at first it has none.
  static void SetCatches(bool on);
  // Returns whether operations may raise SIGFPE: there is a handler for it.  Always false with
  // AddressSanitizer and under Valgrind; the processor that Valgrind emulates raises no SIGFPE.
  static bool Catches();

  // Called when a handler begins: from now on, operations that raise one of the flags `kinds`
  // (FpFlag) raise SIGFPE.
  void Begin(unsigned kinds);
  bool has_begun() const { return has_begun_; }

  // Operations that raise the flag `kind` raise no more SIGFPE.  Called by the signal handler,
  // which changes the MXCSR of the interrupted code itself.
  void GiveUpCatching(unsigned kind) { kinds_ &= ~kind; }

  // Called before and after code of the image calls a function that is not its own.  Such calls may
  // be nested.
  void Enter();
  void Leave();

  // Called when the handler has ended.
  void End();

 private:
  bool has_begun_ = false;
  unsigned kinds_ = 0;     // the flags that raise SIGFPE
  int calls_ = 0;          // depth of calls of functions that are not the image's own
  unsigned saved_fp_ = 0;  // MXCSR of the image during a call
};

}  // namespace openr_host
