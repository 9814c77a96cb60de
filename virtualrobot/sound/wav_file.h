// WAV files: PCM of 8 or 16 bits, mono or stereo, any rate.
#pragma once

#include <OPENR/ODataFormats.h>

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace openr_host {

struct WavSound {
  int rate_hz = 0;
  int channels = 0;              // 1 or 2
  std::vector<int16_t> samples;  // interleaved; 8-bit samples moved into the upper byte
};

// Throws std::runtime_error "NAME: ..." when `bytes` are no WAV file or hold another kind
// of sound.  A data chunk that is cut off is read as far as it goes.
WavSound ParseWav(std::string_view bytes, const std::string& name);

// The same from a file.
WavSound ReadWavFile(const std::string& file);

// At another rate, by straight lines between samples; a mono sound on both sides.
std::vector<OSoundSampleStereo16> ToStereo(const WavSound& sound, int rate_hz);

// The 44 bytes before `data_bytes` of 16-bit mono.
std::string WavHeader(int rate_hz, uint32_t data_bytes);

}  // namespace openr_host
