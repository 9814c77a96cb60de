//
// The first 44 bytes of a WAV file.
//

#ifndef WavHeader_h_DEFINED
#define WavHeader_h_DEFINED

#include <Types.h>

const int WAV_HEADER_SIZE = 44;

// For `dataSize` bytes of 16-bit samples that follow.
void WriteWavHeader(byte* header, int channels, longword samplesPerSecond, longword dataSize);

#endif  // WavHeader_h_DEFINED
