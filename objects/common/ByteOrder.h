//
// Reads and writes little-endian numbers in byte arrays.
//
// Numbers are read and written byte by byte, because an unaligned access is a CPU exception on the
// robot, and because this gives the same result on every host.
//

#ifndef ByteOrder_h_DEFINED
#define ByteOrder_h_DEFINED

#include "FixedTypes.h"

inline Uint16
GetU16(const Uint8* at)
{
    return (Uint16)(at[0] | (at[1] << 8));
}

inline Uint32
GetU32(const Uint8* at)
{
    return (Uint32)at[0] | ((Uint32)at[1] << 8) | ((Uint32)at[2] << 16) | ((Uint32)at[3] << 24);
}

// Reads a number in two's complement.  Converts it by arithmetic, because in C++98 each compiler
// may choose the result when a large unsigned value is cast to a signed type.
inline Sint32
GetS32(const Uint8* at)
{
    const Uint32 bits = GetU32(at);
    return bits < 0x80000000u ? (Sint32)bits : (Sint32)(bits - 0x80000000u) - 0x7fffffff - 1;
}

inline void
PutU16(Uint8* at, Uint16 value)
{
    at[0] = (Uint8)(value & 0xff);
    at[1] = (Uint8)(value >> 8);
}

inline void
PutU32(Uint8* at, Uint32 value)
{
    at[0] = (Uint8)(value & 0xff);
    at[1] = (Uint8)((value >> 8) & 0xff);
    at[2] = (Uint8)((value >> 16) & 0xff);
    at[3] = (Uint8)(value >> 24);
}

inline void
PutS32(Uint8* at, Sint32 value)
{
    PutU32(at, (Uint32)value);
}

#endif  // ByteOrder_h_DEFINED
