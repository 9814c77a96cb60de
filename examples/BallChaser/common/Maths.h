//
// Sine, cosine and arc tangent of our own.
//
// The functions of the C library give results whose last bit depends on the processor.  These
// functions use only + - * /, for which there is one right result, so that the dog walks in the
// same way on every machine.  They are exact to 10^-7, far below one step of a joint's sensor.
// Angles are in radians.
//

#ifndef Maths_h_DEFINED
#define Maths_h_DEFINED

#include <math.h>

const double PI = 3.14159265358979;

inline double
Rad(double degrees)
{
    return degrees * (PI / 180);
}

inline double
Limit(double value, double low, double high)
{
    return value < low ? low : value > high ? high : value;
}

// Returns the same angle between -PI and PI.
inline double
WrapAngle(double x)
{
    while (x > PI) x -= 2 * PI;
    while (x < -PI) x += 2 * PI;
    return x;
}

// Sums the first terms of the series of the sine, after a step to -PI/2..PI/2, where the series is
// short.
inline double
Sin(double x)
{
    x = WrapAngle(x);
    if (x > PI / 2) x = PI - x;
    if (x < -PI / 2) x = -PI - x;
    const double q = x * x;
    return x * (1 - q / 6 * (1 - q / 20 * (1 - q / 42 * (1 - q / 72 * (1 - q / 110)))));
}

inline double
Cos(double x)
{
    return Sin(x + PI / 2);
}

// Returns the arc tangent of t, for t from 0 to 1.  Above tan(PI/8) the angle is taken from PI/4,
// because the series is short for small t only.
inline double
ArcTanOfPart(double t)
{
    if (t > 0.41421356) return PI / 4 - ArcTanOfPart((1 - t) / (1 + t));
    const double q = t * t;
    return t *
           (1 -
            q * (1.0 / 3 -
                 q * (1.0 / 5 -
                      q * (1.0 / 7 - q * (1.0 / 9 - q * (1.0 / 11 - q * (1.0 / 13 - q / 15)))))));
}

// Returns the direction of the point (x, y), from -PI to PI; 0 for the origin.
inline double
ArcTan2(double y, double x)
{
    const double ay = y < 0 ? -y : y;
    const double ax = x < 0 ? -x : x;
    if (ax == 0 && ay == 0) return 0;
    double angle = ay <= ax ? ArcTanOfPart(ay / ax) : PI / 2 - ArcTanOfPart(ax / ay);
    if (x < 0) angle = PI - angle;
    return y < 0 ? -angle : angle;
}

// Returns the angle between 0 and PI whose cosine is c.  The square root of the C library is exact
// everywhere.
inline double
ArcCos(double c)
{
    c = Limit(c, -1, 1);
    return ArcTan2(sqrt(1 - c * c), c);
}

#endif  // Maths_h_DEFINED
