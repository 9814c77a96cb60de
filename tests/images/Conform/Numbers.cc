// Floating-point operations that the robot's processor does not forgive, and some that it does.
#include <OPENR/OSyslog.h>
#include <float.h>
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "Teller.h"

// Nothing of it is computed by the compiler.
static volatile double zero = 0, one = 1, large = 1e10, tiny = DBL_MIN, result;

// Returns the float with these bits, as a program gets it from memory that holds no number.
static float
FloatOfBits(int bits)
{
    float value;
    memcpy(&value, &bits, sizeof value);
    return value;
}

bool
NumberCommand(const std::string& command)
{
    if (command == "fp nan") {
        result = zero / zero;
    } else if (command == "fp sqrt") {
        result = sqrt(-one);
    } else if (command == "fp int") {
        result = (int)large;
    } else if (command == "fp inf") {
        result = one / zero;
    } else if (command == "fp denormal") {
        volatile float value = FloatOfBits(1234);
        result = value * one;
    } else if (command == "fp foreign") {
        volatile float value = FloatOfBits(0x7fc00000);
        result = value + 1.0f;
    } else if (command == "fp compare") {
        volatile float value = FloatOfBits(0x7fc00000);
        result = value < 1.0f ? 1 : 0;
    } else if (command == "fp whole") {
        volatile float value = FloatOfBits(0x7fc00000);
        result = (int)value;
    } else if (command == "fp print") {
        char text[80];
        volatile float value = FloatOfBits(0x7fc00000);
        sprintf(text, "%% %s %-*d %ld %c %5.1f", "text", 4, 5, 6L, 'c', value);
    } else if (command == "fp console") {
        volatile float value = FloatOfBits(0x7fc00000);
        OSYSPRINT(("%ld %s %.2f\n", (longword)7, "text", value));
    } else if (command == "fp text") {
        char text[80];
        sprintf(text, "nan %% %s %-*d %lld %p %5.1f %e", "nan", 4, 5, 6LL, (void*)text, 1.5, 1e300);
    } else if (command == "fp decay") {
        result = tiny * 1.7;
        for (int i = 0; i < 1000; i++) result = result * 0.9;
    } else if (command == "fp fine") {
        result = one / 3 + sin(one) + exp(-large) + pow(one, large) + atan2(zero, zero) + sqrt(one) + fmod(large, one);
    } else {
        return false;
    }
    OSYSPRINT(("T computed\n"));
    return true;
}
