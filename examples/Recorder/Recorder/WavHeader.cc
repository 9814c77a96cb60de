#include "WavHeader.h"

#include <string.h>

// Writes `value` byte by byte, because a write to an address that is no multiple of its size would
// stop the robot's processor.
static void
Put(byte* place, longword value, int size)
{
    for (int i = 0; i < size; i++) place[i] = (byte)(value >> (8 * i));
}

void
WriteWavHeader(byte* header, int channels, longword samplesPerSecond, longword dataSize)
{
    const int sampleSize = 2 * channels;
    memcpy(header, "RIFF    WAVEfmt ", 16);
    Put(header + 4, 36 + dataSize, 4);
    Put(header + 16, 16, 4);  // size of this chunk
    Put(header + 20, 1, 2);   // PCM
    Put(header + 22, channels, 2);
    Put(header + 24, samplesPerSecond, 4);
    Put(header + 28, samplesPerSecond * sampleSize, 4);
    Put(header + 32, sampleSize, 2);
    Put(header + 34, 16, 2);  // bits per sample
    memcpy(header + 36, "data", 4);
    Put(header + 40, dataSize, 4);
}
