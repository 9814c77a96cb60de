// ArithmeticWatch: finds the instruction of a handler that makes a NaN or an infinity, or uses a
// denormal number.
//
// While the handler's own code runs, such an instruction raises SIGFPE.  Results that would be
// denormal numbers become 0 meanwhile, as on the robot (field-notes.md, 4.4).  So a denormal number
// that raises SIGFPE was not made by the handler's own arithmetic.
//
// Functions of the SDK and of the C library are not the handler's own code.  Objects of the classes
// ApiScope and LibraryScope (current.h) pause the ArithmeticWatch while such a function runs, so
// that its operations raise no SIGFPE.
//
// An ArithmeticWatch also keeps the rounding mode that a handler has set (fesetround()) away from
// these functions and from all code that runs after the handler.  So every handler of an image has
// an ArithmeticWatch, even if operations must not raise SIGFPE.
#pragma once

#include <cstdint>

namespace openr_host {

class ArithmeticWatch {
 public:
  // Sets whether this process has a signal handler for SIGFPE, as the class CrashLog installs it;
  // at first there is none.  Without the signal handler a SIGFPE would end the process, so
  // floating-point operations must not raise SIGFPE then.
  static void SetCatches(bool on);
  // Returns whether floating-point operations may raise SIGFPE, that is, whether this process has a
  // signal handler for it.  Always false with AddressSanitizer, and under Valgrind, because the
  // processor that Valgrind emulates raises no SIGFPE.
  static bool Catches();

  // Starts the watch at the beginning of a handler: from now on, operations that set one of the
  // flags `kinds` (FpFlag) raise SIGFPE, and results that would be denormal numbers become 0.  If
  // Catches() is false, operations raise no SIGFPE, and results may be denormal numbers.
  void Begin(unsigned kinds);
  bool has_begun() const { return has_begun_; }

  // Makes operations that set the flag `kind` (FpFlag) raise no SIGFPE for the rest of the handler,
  // because each kind of operation is reported only once.  Called by the signal handler of SIGFPE
  // after it has recorded the instruction.  For the interrupted code, the signal handler itself
  // changes the register MXCSR, so that the instruction does not raise SIGFPE again.
  void DisableTrap(unsigned kind) { kinds_ &= ~kind; }

  // Pauses the watch for floating-point faults, and sets the rounding mode to the nearest number.
  // Called at the beginning of a function of the SDK or of the C library that the image's code has
  // called.  Calls of Pause() and Resume() may be nested.
  void Pause();
  // Resumes the watch for floating-point faults, and restores the rounding mode that the handler
  // has set.  Called when a function for which Pause() was called has returned.
  void Resume();

  // Ends the watch for floating-point faults at the end of the handler: floating-point operations
  // raise no SIGFPE any more, results may be denormal numbers, and they are rounded to the nearest
  // number.
  void End();

 private:
  bool has_begun_ = false;
  unsigned kinds_ = 0;  // flags (FpFlag) whose operations raise SIGFPE
  // The number of functions of the SDK and the C library that the watched handler has called and
  // that have not returned yet.  While the number is not 0, floating-point operations raise no
  // SIGFPE, because they are not operations of the handler's own code.
  int calls_ = 0;
  // The image's value of MXCSR, the register that enables SIGFPE and has the rounding mode, kept
  // while a function of the SDK or of the C library runs.
  unsigned saved_fp_ = 0;
  uint16_t saved_x87_ = 0;  // the same for the control word of the old coprocessor (fp_flags.h)
};

}  // namespace openr_host
