//
// Writes the header of a WAV file, its first 44 bytes.
//

#ifndef WavHeader_h_DEFINED
#define WavHeader_h_DEFINED

#include <Types.h>

const int WAV_HEADER_SIZE = 44;

// Writes the header for `dataSize` bytes of 16-bit samples, which follow it in the file.
void WriteWavHeader(byte* header, int channels, longword samplesPerSecond, longword dataSize);

#endif  // WavHeader_h_DEFINED
