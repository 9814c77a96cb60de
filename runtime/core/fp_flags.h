// Reads the floating-point flags, which tell what kinds of operations happened since the flags were
// last cleared.
//
// On x86-64 only the flags of SSE2 are read, with one instruction. fetestexcept() would also read
// the flags of the old coprocessor, which takes longer than a short handler.
#pragma once

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
// Undoes what SetFpTraps() has set, and leaves the flags as they are.  From now on no
// floating-point operation raises SIGFPE, and results may be denormal numbers.
inline void EndFpTraps() { _mm_setcsr((_mm_getcsr() | kFpAll << kFpMaskShift) & ~kFpFlushToZero); }
#else
inline unsigned FpState() { return 0; }
inline void SetFpState(unsigned) {}
inline void SetFpTraps(unsigned) {}
inline void EndFpTraps() {}
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

// While a FlushScope exists, results that would be denormal numbers become 0, as on the robot.
class FlushScope {
 public:
  FlushScope() { SetFpState(saved_fp_ | kFpFlushToZero); }
  ~FlushScope() { SetFpState(saved_fp_); }
  FlushScope(const FlushScope&) = delete;
  FlushScope& operator=(const FlushScope&) = delete;

 private:
  const unsigned saved_fp_ = FpState();
};

}  // namespace openr_host
