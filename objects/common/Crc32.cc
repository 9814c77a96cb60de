#include "Crc32.h"

// Table for the CRC-32 with the polynomial 0xedb88320: the remainders of the 16 values of four
// bits.  Four bits at a time are a compromise: a table for eight bits would take 1 KB, and to
// compute the CRC bit by bit would be slow on the robot.
static const Uint32 REMAINDER[16] = {
    0x00000000, 0x1db71064, 0x3b6e20c8, 0x26d930ac, 0x76dc4190, 0x6b6b51f4, 0x4db26158, 0x5005713c,
    0xedb88320, 0xf00f9344, 0xd6d6a3e8, 0xcb61b38c, 0x9b64c2b0, 0x86d3d2d4, 0xa00ae278, 0xbdbdf21c,
};

Uint32
Crc32(Uint32 before, const Uint8* bytes, int size)
{
    Uint32 crc = ~before;
    for (int i = 0; i < size; i++) {
        crc ^= bytes[i];
        crc = (crc >> 4) ^ REMAINDER[crc & 15];
        crc = (crc >> 4) ^ REMAINDER[crc & 15];
    }
    return ~crc;
}
