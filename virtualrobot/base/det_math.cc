#include "virtualrobot/base/det_math.h"

#include <cstdint>

#include "runtime/base/assert.h"

namespace openr_host {
namespace {

// pi/2 as the sum of three numbers.  The first two have only 33 significant bits.  So their
// products with the number of quarter turns (n in Reduce(), below 2^20) are exact.
constexpr double kHalfPi1 = 0x1.921fb544p+0;
constexpr double kHalfPi2 = 0x1.0b4611a6p-34;
constexpr double kHalfPi3 = 0x1.3198a2e037073p-69;

// SinKernel() and CosKernel() compute sine and cosine of `r` by Taylor series, for |r| <= pi/4.
// For such `r` the first term that is left out is below 1e-17.
double SinKernel(double r) {
  const double z = r * r;
  double sum = 1.0 / 355687428096000.0;  // coefficient of r^17: 1/17!
  sum = sum * z - 1.0 / 1307674368000.0;
  sum = sum * z + 1.0 / 6227020800.0;
  sum = sum * z - 1.0 / 39916800.0;
  sum = sum * z + 1.0 / 362880.0;
  sum = sum * z - 1.0 / 5040.0;
  sum = sum * z + 1.0 / 120.0;
  sum = sum * z - 1.0 / 6.0;
  return r + r * (z * sum);
}

double CosKernel(double r) {
  const double z = r * r;
  double sum = 1.0 / 20922789888000.0;  // coefficient of r^16: 1/16!
  sum = sum * z - 1.0 / 87178291200.0;
  sum = sum * z + 1.0 / 479001600.0;
  sum = sum * z - 1.0 / 3628800.0;
  sum = sum * z + 1.0 / 40320.0;
  sum = sum * z - 1.0 / 720.0;
  sum = sum * z + 1.0 / 24.0;
  sum = sum * z - 1.0 / 2.0;
  return 1.0 + z * sum;
}

struct Quadrant {
  double r;  // the angle without its quarter turns, in [-pi/4, pi/4]
  int q;     // number of the quadrant, 0 to 3: x = r + q pi/2 (mod 2 pi)
};

Quadrant Reduce(double x) {
  // Refuses angles beyond 10^6 rad.  Up to this limit, the number n of quarter turns is below 2^20,
  // so the products of n with kHalfPi1 and kHalfPi2 below are exact.
  ASSERT(x >= -1e6 && x <= 1e6, "an angle of {} rad", x);
  const double turns = x * (2.0 / kPi);
  const int64_t n = static_cast<int64_t>(turns < 0 ? turns - 0.5 : turns + 0.5);
  const double nd = static_cast<double>(n);
  const double r = ((x - nd * kHalfPi1) - nd * kHalfPi2) - nd * kHalfPi3;
  return {r, static_cast<int>(n & 3)};
}

// Returns sin(x + shift * pi/2) for an angle x.  `a` is the result of Reduce(x).
double SinOfQuadrant(const Quadrant& a, int shift) {
  const int q = (a.q + shift) & 3;
  const double magnitude = (q & 1) ? CosKernel(a.r) : SinKernel(a.r);
  return (q & 2) ? -magnitude : magnitude;
}

// Table of arc tangents: element k is atan(k / 8).
constexpr double kAtanOfEighths[9] = {
    0x0.0p+0,
    0x1.fd5ba9aac2f6ep-4,
    0x1.f5b75f92c80ddp-3,
    0x1.6f61941e4def1p-2,
    0x1.dac670561bb4fp-2,
    0x1.1e00babdefeb4p-1,
    0x1.4978fa3269ee1p-1,
    0x1.700a7c5784634p-1,
    0x1.921fb54442d18p-1,
};

// Returns atan(small / large).  REQUIRES: 0 <= small <= large, large > 0.
double AtanOfRatio(double small, double large) {
  const int k = static_cast<int>(small / large * 8 + 0.5);
  const double c = k / 8.0;
  // Uses atan(t) = atan(c) + atan(u) with t = small / large and u = (t - c) / (1 + t c).  c is the
  // multiple of 1/8 nearest to t, so kAtanOfEighths has the arc tangent of c.  A short series is
  // enough for atan(u), because u is at most 1/16 in size.
  const double u = (small - c * large) / (large + c * small);
  const double z = u * u;
  double sum = 1.0 / 13.0;
  sum = sum * z - 1.0 / 11.0;
  sum = sum * z + 1.0 / 9.0;
  sum = sum * z - 1.0 / 7.0;
  sum = sum * z + 1.0 / 5.0;
  sum = sum * z - 1.0 / 3.0;
  return kAtanOfEighths[k] + (u + u * (z * sum));
}

}  // namespace

double DetSin(double x) { return SinOfQuadrant(Reduce(x), 0); }

double DetCos(double x) { return SinOfQuadrant(Reduce(x), 1); }

double DetAtan2(double y, double x) {
  const double ax = x < 0 ? -x : x;
  const double ay = y < 0 ? -y : y;
  if (ax == 0 && ay == 0) return 0;
  double angle = ay <= ax ? AtanOfRatio(ay, ax) : kPi / 2 - AtanOfRatio(ax, ay);
  if (x < 0) angle = kPi - angle;
  return y < 0 ? -angle : angle;
}

}  // namespace openr_host
