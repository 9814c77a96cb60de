//
// Integer types of a fixed width.
//
// The robot's headers have such types (byte, longword, int32), but objects/common must also compile
// without these headers, and the robot's C library has no <stdint.h>.
//

#ifndef FixedTypes_h_DEFINED
#define FixedTypes_h_DEFINED

typedef signed char Sint8;
typedef unsigned char Uint8;
typedef short Sint16;
typedef unsigned short Uint16;
typedef int Sint32;
typedef unsigned int Uint32;
typedef long long Sint64;

// Makes the compilation fail when `condition` is false.  Used at namespace scope or in a class;
// `name` must be an identifier that is not used elsewhere.
#define COMPILE_TIME_CHECK(name, condition) typedef char name[(condition) ? 1 : -1]

COMPILE_TIME_CHECK(Sint16HasTwoBytes, sizeof(Sint16) == 2);
COMPILE_TIME_CHECK(Sint32HasFourBytes, sizeof(Sint32) == 4);
COMPILE_TIME_CHECK(Sint64HasEightBytes, sizeof(Sint64) == 8);

#endif  // FixedTypes_h_DEFINED
