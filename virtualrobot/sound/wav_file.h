// Reads WAV files: PCM of 8 or 16 bits, mono or stereo, with 1,000 to 192,000 samples per second.
// The longest sound has 4 hours.
#pragma once

#include <OPENR/ODataFormats.h>

#include <cstdint>
#include <string>
#include <vector>

namespace openr_host {

struct WavSound {
  int rate_hz = 0;
  int channels = 0;  // number of channels: 1 or 2
  // Samples of all channels, interleaved; an 8-bit sample is in the upper byte.
  std::vector<int16_t> samples;
};

// Reads the whole file.  If the file is cut off, reads the samples up to its end.  Throws
// std::runtime_error with the text "FILE: reason" when the file cannot be read, is no WAV file or
// holds another kind of sound.
WavSound ReadWavFile(const std::string& file);

// Converts `sound` to stereo with `rate_hz` samples per second, by linear interpolation between
// samples.  Both channels of the result are the same if `sound` is mono.
std::vector<OSoundSampleStereo16> ToStereo(const WavSound& sound, int rate_hz);

// Describes the last error of `sndfile`, which is a SNDFILE*.  If `sndfile` is null, describes why
// the last attempt to open a file failed.  For an error of the operating system, returns only the
// system's message, without the words that libsndfile adds.
std::string SoundFileError(void* sndfile);

}  // namespace openr_host
