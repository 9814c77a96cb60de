// WAV files: PCM of 8 or 16 bits, mono or stereo, any rate.
#pragma once

#include <OPENR/ODataFormats.h>

#include <cstdint>
#include <string>
#include <vector>

namespace openr_host {

struct WavSound {
  int rate_hz = 0;
  int channels = 0;              // 1 or 2
  std::vector<int16_t> samples;  // interleaved; 8-bit samples are in the upper byte
};

// Reads the whole file.  A file that is cut off is read as far as it goes.  Throws
// std::runtime_error "FILE: ..." when the file cannot be read, is no WAV file or holds another kind
// of sound.
WavSound ReadWavFile(const std::string& file);

// Converts to another rate, by straight lines between samples.  A mono sound goes to both sides.
std::vector<OSoundSampleStereo16> ToStereo(const WavSound& sound, int rate_hz);

// The reason of the newest error of `sndfile` (a SNDFILE*; null: of the newest attempt to open a
// file), without the words that libsndfile puts around the system's text.
std::string SoundFileError(void* sndfile);

}  // namespace openr_host
