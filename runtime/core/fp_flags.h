// Reads the floating-point flags, which tell what kinds of operations happened since the flags were
// last cleared.
//
// On x86-64 only the flags of SSE2 are read, with one instruction. fetestexcept() would also read
// the flags of the old coprocessor, which takes longer than a short handler.
#pragma once

#include <cstdint>

#if defined(__SSE2__)
#include <xmmintrin.h>
#else
#include <cfenv>
#endif

namespace openr_host {

// Bits of the register MXCSR, the floating-point flags.  Each bit tells that an operation of one
// kind was done since the bit was cleared.
enum FpFlag : unsigned {
  kFpInvalid = 0x01,    // a NaN was made, or an integer type cannot hold the converted number
  kFpDenormal = 0x02,   // an operand was a denormal number
  kFpDivByZero = 0x04,  // a division by 0 has made an infinity
  kFpOverflow = 0x08,   // a result was too large and became an infinity
  kFpUnderflow = 0x10,  // a result was too small for a normal number
};
constexpr unsigned kFpAll = 0x1f;
constexpr int kFpKinds = 5;  // number of bits in kFpAll
// The flags of operations that would stop the robot.  An ArithmeticWatch (arithmetic_watch.h) lets
// these operations raise SIGFPE, and so finds the instruction that raises a flag.
constexpr unsigned kFpCaught = kFpInvalid | kFpDenormal | kFpDivByZero | kFpOverflow;
// The distance in bits between a flag in the register MXCSR and its mask bit in the same register.
// While the mask bit is set, floating-point operations that set the flag raise no SIGFPE.
constexpr int kFpMaskShift = 7;
// Bit of the register MXCSR: results that would be denormal numbers become 0, as on the robot
// (field-notes.md, 4.4).  The processor then sets the flag kFpUnderflow.
constexpr unsigned kFpFlushToZero = 0x8000;
// The flags of the register MXCSR, also the flag for a rounded result, which nothing here reads.
constexpr unsigned kFpFlagBits = 0x3f;
// The register MXCSR with which a program begins: results are rounded to the nearest number, no
// operation raises SIGFPE, and no flag is set.
constexpr unsigned kFpStart = 0x1f80;
// The control word of the old coprocessor (x87) with which a program begins.  The coprocessor
// computes with long double.  printf(), strtod() and fegetround() of the GNU C library read the
// rounding mode from its control word, for double too.
constexpr uint16_t kX87Start = 0x37f;

// Without SSE2 the next four functions, which read and set the register MXCSR (the floating-point
// flags, their mask bits, and kFpFlushToZero), do nothing.
#if defined(__SSE2__)
// Returns the register MXCSR (the floating-point flags and their mask bits), so that SetFpState()
// can restore it later.
inline unsigned FpState() { return _mm_getcsr(); }
// Sets the register MXCSR (the floating-point flags and their mask bits) to `state`, which
// FpState() has returned.
inline void SetFpState(unsigned state) { _mm_setcsr(state); }
// Clears the flags `kinds`.  From now on, floating-point operations that set one of these flags
// raise SIGFPE, other operations do not, and results that would be denormal numbers become 0.
inline void SetFpTraps(unsigned kinds) {
  constexpr unsigned kSet = kFpAll << kFpMaskShift | kFpFlushToZero;
  _mm_setcsr((_mm_getcsr() | kSet) & ~(kinds << kFpMaskShift | kinds));
}
// Undoes what SetFpTraps() and the code of an image have set in MXCSR, and leaves the flags as they
// are.  From now on no floating-point operation raises SIGFPE, results may be denormal numbers, and
// results are rounded to the nearest number.
inline void EndFpTraps() { _mm_setcsr((_mm_getcsr() & kFpFlagBits) | kFpStart); }
#else
inline unsigned FpState() { return 0; }
inline void SetFpState(unsigned) {}
inline void SetFpTraps(unsigned) {}
inline void EndFpTraps() {}
#endif

// Reads and sets the control word of the old coprocessor, which has its rounding mode.  On other
// processors than x86-64 these functions do nothing.
#if defined(__x86_64__)
inline uint16_t X87State() {
  uint16_t state;
  asm volatile("fnstcw %0" : "=m"(state));
  return state;
}
// Clears the coprocessor's flags first, because a flag that is set would raise SIGFPE if the new or
// the old control word enables that.
inline void SetX87State(uint16_t state) { asm volatile("fnclex\n\tfldcw %0" : : "m"(state)); }
#else
inline uint16_t X87State() { return kX87Start; }
inline void SetX87State(uint16_t) {}
#endif

#if defined(__SSE2__)
inline unsigned FpFlags() { return _mm_getcsr() & kFpAll; }
inline void ClearFpFlags() { _mm_setcsr(_mm_getcsr() & ~kFpAll); }
#else
inline unsigned FpFlags() {
  const int set = std::fetestexcept(FE_INVALID | FE_DIVBYZERO | FE_OVERFLOW | FE_UNDERFLOW);
  return (set & FE_INVALID ? kFpInvalid : 0u) | (set & FE_DIVBYZERO ? kFpDivByZero : 0u) |
         (set & FE_OVERFLOW ? kFpOverflow : 0u) | (set & FE_UNDERFLOW ? kFpUnderflow : 0u);
}
inline void ClearFpFlags() { std::feclearexcept(FE_ALL_EXCEPT); }
#endif

// Restores, in its destructor, the floating-point state of its constructor: the rounding mode, the
// flags and their mask bits.  Used around code of an image that is no handler, because this code
// may change the rounding mode by fesetround().
class FpScope {
 public:
  FpScope() = default;
  ~FpScope() {
    SetFpState(saved_fp_);
    if (X87State() != saved_x87_) SetX87State(saved_x87_);
  }
  FpScope(const FpScope&) = delete;
  FpScope& operator=(const FpScope&) = delete;

  // From now on results that would be denormal numbers become 0, as on the robot.
  void Flush() { SetFpState(saved_fp_ | kFpFlushToZero); }

 private:
  const unsigned saved_fp_ = FpState();
  const uint16_t saved_x87_ = X87State();
};

}  // namespace openr_host
