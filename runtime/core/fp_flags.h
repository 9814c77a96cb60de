// What floating-point operations left behind since the flags were last cleared.
//
// Only what SSE2 says on x86-64: reading is one instruction, where fetestexcept() also asks the
// old coprocessor, which takes longer than a handler.
#pragma once

#if defined(__SSE2__)
#include <xmmintrin.h>
#else
#include <cfenv>
#endif

namespace openr_host {

// Bits of MXCSR.
enum FpFlag : unsigned {
  kFpInvalid = 0x01,    // a NaN was made, or a number does not fit its integer type
  kFpDenormal = 0x02,   // an operand was denormal
  kFpDivByZero = 0x04,  // an infinity was made
  kFpOverflow = 0x08,   // an infinity was made
  kFpUnderflow = 0x10,  // a result was too small for a normal number
};
constexpr unsigned kFpAll = 0x1f;
constexpr int kFpKinds = 5;  // bits of it
// The flags that say something about the robot and can be caught where they are raised.
constexpr unsigned kFpCaught = kFpInvalid | kFpDenormal | kFpDivByZero | kFpOverflow;
// The bit of MXCSR that keeps a kind from raising SIGFPE is this far left of the kind's flag.
constexpr int kFpMaskShift = 7;

// The settings and flags of floating-point operations, to be put back later; and which kinds raise
// SIGFPE.  Processors without SSE2 have neither here.
#if defined(__SSE2__)
inline unsigned FpState() { return _mm_getcsr(); }
inline void SetFpState(unsigned state) { _mm_setcsr(state); }
inline void CatchFp(unsigned kinds) {
  _mm_setcsr((_mm_getcsr() | kFpAll << kFpMaskShift) & ~(kinds << kFpMaskShift | kinds));
}
#else
inline unsigned FpState() { return 0; }
inline void SetFpState(unsigned) {}
inline void CatchFp(unsigned) {}
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

}  // namespace openr_host
