// Angles: pi, degrees, radians.
#pragma once

#include <cmath>

namespace openr_host::motions {

inline constexpr double kPi = M_PI;

inline constexpr double Radians(double degrees) { return degrees * (kPi / 180); }
inline constexpr double Degrees(double radians) { return radians * (180 / kPi); }

}  // namespace openr_host::motions
