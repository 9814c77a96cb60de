// ClearUpperRegisters(): clears the upper halves of the processor's vector registers, because bits
// that are left there make other code slow.
//
// Code compiled for AVX, such as the C library's string functions and xxHash, may leave bits in the
// upper halves of the 16 vector registers.  Code compiled for SSE, such as libode, the images and
// most of this program, writes only the lower half of a register and must keep these bits.  So on
// several processors an SSE instruction waits until the previous instruction that wrote the same
// register has ended.  The results are the same, but the code takes longer (docs/performance.md,
// "Upper halves").
#pragma once

namespace openr_host {

// Sets the upper halves of the vector registers to zero, so that SSE instructions no longer wait
// for each other.  Called before long stretches of SSE code.  Does nothing on a processor without
// AVX.  Does nothing in a build for AVX either, because the compiler itself clears the registers
// there.
#if defined(__x86_64__) && !defined(__AVX__)
inline void ClearUpperRegisters() {
  if (__builtin_cpu_supports("avx")) asm volatile("vzeroupper");
}
#else
inline void ClearUpperRegisters() {}
#endif

}  // namespace openr_host
