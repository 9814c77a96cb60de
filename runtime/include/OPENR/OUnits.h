// Types for physical quantities, which are integers in millionths of the SI unit.
#ifndef OPENR_OUNITS_H_INCLUDED
#define OPENR_OUNITS_H_INCLUDED

#include <Types.h>

typedef slongword Length;           // in 10^-6 m
typedef slongword Mass;             // in 10^-6 kg
typedef slongword Angle;            // in 10^-6 rad
typedef slongword Temperature;      // in 10^-6 degree Celsius
typedef slongword Velocity;         // in 10^-6 m/s
typedef slongword Acceleration;     // in 10^-6 m/s^2
typedef slongword AngularVelocity;  // in 10^-6 rad/s
typedef slongword Force;            // in 10^-6 N
typedef slongword Percentage;       // in 10^-6 %

// The angles pi, pi/2 and pi/4 in 10^-6 rad, truncated.
const Angle oradiansPI = 3141592;
const Angle oradiansPI_2 = 1570796;
const Angle oradiansPI_4 = 785398;

// Returns `value` in millionths, truncated toward zero.  REQUIRES: |value| < 2147.
inline slongword micro(double value) { return static_cast<slongword>(value * 1000000.0); }

inline double radians(double deg) { return deg * 3.14159265358979323846 / 180.0; }
inline double degrees(double rad) { return rad * 180.0 / 3.14159265358979323846; }

// Converts degrees to 10^-6 rad, the unit of every joint command.
inline slongword oradians(double deg) { return micro(radians(deg)); }

#endif  // OPENR_OUNITS_H_INCLUDED
