// Sine, cosine and arc tangent whose results have the same bits on every x86-64 processor.
//
// glibc chooses at run time between variants with and without fused multiply-add, so the last bit
// of its results depends on the processor.  The functions here use only +, -, *, / and sqrt, for
// which IEEE 754 allows only one result.  They must be compiled without contraction
// (-ffp-contract=off).  All code whose results become state of the simulation calls these functions
// and never libm.
#pragma once

namespace openr_host {

inline constexpr double kPi = 3.14159265358979323846;

inline constexpr double Radians(double degrees) { return degrees * (kPi / 180); }
inline constexpr double Degrees(double radians) { return radians * (180 / kPi); }

// DetSin() and DetCos() compute sine and cosine of `x` in radians, within 2e-16 of the true value
// for |x| <= 1000; no joint turns by so large an angle.  REQUIRES: |x| <= 1e6, because the
// reduction of a greater angle to one quadrant loses digits.
double DetSin(double x);
double DetCos(double x);

// Returns the angle of the point (x, y), in [-pi, pi] rad, within 5e-16 of the true value; 0 for
// the origin.  A negative zero counts as zero: DetAtan2(-0.0, -1) is +pi.
double DetAtan2(double y, double x);

}  // namespace openr_host
