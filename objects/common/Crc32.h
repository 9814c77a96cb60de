//
// The CRC-32 of files that are sent over the network, as in zlib, gzip and IEEE 802.3.
//

#ifndef Crc32_h_DEFINED
#define Crc32_h_DEFINED

#include "FixedTypes.h"

// Returns the CRC-32 of a sequence of bytes that arrives in parts.  `bytes` is the next part.
// `before` is the CRC-32 of all earlier parts, and 0 for the first part.
Uint32 Crc32(Uint32 before, const Uint8* bytes, int size);

#endif  // Crc32_h_DEFINED
