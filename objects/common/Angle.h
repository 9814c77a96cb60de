//
// The two units of angles in the objects, and the conversion between them.
//
//   urad   microradians: command vectors, sensor vectors, MTN files (Level 2 Reference
//          Guide 4.2.1; Hohl 2004, appendix A)
//   cdeg   hundredths of a degree, of a degree/s, of a degree/s^2: the unit of the remote
//          control (Hohl 2004, table 3.10) and of the speed tables
//
// All results are whole numbers, rounded to the nearest (half away from zero), so that every
// compiler and every word size gives the same result.
//

#ifndef Angle_h_DEFINED
#define Angle_h_DEFINED

#include "FixedTypes.h"

// Returns numerator / denominator, rounded to the nearest, half away from zero.  REQUIRES:
// denominator > 0.
inline Sint64
DivideRounded(Sint64 numerator, Sint64 denominator)
{
    const Sint64 half = denominator / 2;
    return numerator >= 0 ? (numerator + half) / denominator : -((half - numerator) / denominator);
}

// Number of urad (10^-6 rad) in one cdeg (0.01 degree), times 10^9: pi / 18000 x 10^6 x 10^9.
const Sint64 URAD_PER_CDEG_E9 = 174532925199LL;

// Number of urad in a radian, the unit in which controllers give positions.
const double URAD_PER_RAD = 1e6;

// Number of cdeg (0.01 degree) in a radian.
const double CDEG_PER_RAD = 5729.577951308232;

// Converts an angle in 0.01 degree to urad.  An angle of more than 100 turns counts as 100 turns,
// so that the result fits 32 bits.
inline Sint32
UradFromCdeg(Sint32 cdeg)
{
    const Sint32 MAX_CDEG = 100 * 36000;
    if (cdeg > MAX_CDEG) cdeg = MAX_CDEG;
    if (cdeg < -MAX_CDEG) cdeg = -MAX_CDEG;
    return (Sint32)DivideRounded((Sint64)cdeg * URAD_PER_CDEG_E9, 1000000000LL);
}

inline Sint32
CdegFromUrad(Sint32 urad)
{
    return (Sint32)DivideRounded((Sint64)urad * 1000000000LL, URAD_PER_CDEG_E9);
}

inline Sint32
Clamp(Sint32 value, Sint32 low, Sint32 high)
{
    return value < low ? low : (value > high ? high : value);
}

#endif  // Angle_h_DEFINED
