#include "virtualrobot/sound/wav_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <memory>
#include <stdexcept>
#include <string_view>
#include <utility>

#include "runtime/base/assert.h"
#include "virtualrobot/sound/sound_library.h"

namespace openr_host {
namespace {

// Limits of the samples per second.  ToStereo() makes 16 samples or fewer from a sample of a file
// with at least kRateMin, so a small file cannot take all memory.
constexpr int kRateMin = 1'000;
constexpr int kRateMax = 192'000;

// Limit of the length of a sound, 4 hours.  As stereo of 16 kHz, such a sound takes 0.9 GB.
constexpr int kSecondsMax = 4 * 3600;

template <typename... Args>
[[noreturn]] void FailToRead(const std::string& file, fmt::format_string<Args...> format,
                             Args&&... args) {
  throw std::runtime_error(file + ": " + fmt::format(format, std::forward<Args>(args)...));
}

// Returns libsndfile's name of a kind of samples, such as "32 bit float".
std::string NameOfSamples(int subtype) {
  SF_FORMAT_INFO info{};
  info.format = subtype;
  const bool is_known = Sndfile().sf_command(nullptr, SFC_GET_FORMAT_INFO, &info, sizeof info) == 0;
  return is_known && info.name != nullptr ? info.name : fmt::format("unknown ({:#x})", subtype);
}

// Throws std::runtime_error if `file`, which libsndfile could open, is no WAV file or cannot be
// used as the sound that the simulated microphone hears.  `info` describes the content of the file.
void CheckSound(const std::string& file, const SF_INFO& info) {
  const int type = info.format & SF_FORMAT_TYPEMASK;
  const int subtype = info.format & SF_FORMAT_SUBMASK;
  if (type != SF_FORMAT_WAV && type != SF_FORMAT_WAVEX) FailToRead(file, "is no WAV file");
  if (subtype != SF_FORMAT_PCM_U8 && subtype != SF_FORMAT_PCM_16) {
    FailToRead(file, "holds samples of kind '{}'; PCM of 8 or 16 bits is read",
               NameOfSamples(subtype));
  }
  if (info.channels != 1 && info.channels != 2)
    FailToRead(file, "has {} channels; 1 or 2 are read", info.channels);
  if (info.samplerate < kRateMin || info.samplerate > kRateMax) {
    FailToRead(file, "has {} samples a second; {} to {} are read", info.samplerate, kRateMin,
               kRateMax);
  }
}

}  // namespace

std::string SoundFileError(void* sndfile) {
  constexpr std::string_view kPrefix = "System error : ";
  std::string text = Sndfile().sf_strerror(static_cast<SNDFILE*>(sndfile));
  if (text.starts_with(kPrefix)) text.erase(0, kPrefix.size());
  if (text.ends_with('.')) text.pop_back();
  return text;
}

WavSound ReadWavFile(const std::string& file) {
  SF_INFO info{};
  const std::unique_ptr<SNDFILE, int (*)(SNDFILE*)> input(
      Sndfile().sf_open(file.c_str(), SFM_READ, &info), Sndfile().sf_close);
  if (input == nullptr) {
    const std::string why = SoundFileError(nullptr);
    if (Sndfile().sf_error(nullptr) == SF_ERR_SYSTEM) FailToRead(file, "cannot be read: {}", why);
    FailToRead(file, "is no WAV file that can be read: {}", why);
  }
  CheckSound(file, info);
  WavSound sound;
  sound.rate_hz = info.samplerate;
  sound.channels = info.channels;
  const auto samples_max = static_cast<size_t>(kSecondsMax) * static_cast<size_t>(sound.rate_hz) *
                           static_cast<size_t>(sound.channels);
  // Reads until the file ends, because the header of a file that was cut off promises more samples
  // than the file has.
  std::array<int16_t, 4096> piece;
  for (;;) {
    const auto wanted = static_cast<sf_count_t>(piece.size()) / sound.channels;
    const sf_count_t count = Sndfile().sf_readf_short(input.get(), piece.data(), wanted);
    if (count <= 0) return sound;
    sound.samples.insert(sound.samples.end(), piece.begin(),
                         piece.begin() + count * sound.channels);
    if (sound.samples.size() > samples_max)
      FailToRead(file, "is longer than {} s, the most that is read", kSecondsMax);
  }
}

std::vector<OSoundSampleStereo16> ToStereo(const WavSound& sound, int rate_hz) {
  ASSERT(sound.channels > 0 && sound.rate_hz > 0 && rate_hz > 0, "{} channels, {} to {} Hz",
         sound.channels, sound.rate_hz, rate_hz);
  // Computes with integers only, so that every machine gets the same samples.
  const auto channels = static_cast<size_t>(sound.channels);
  const size_t length = sound.samples.size() / channels;
  const auto at = [&](size_t index, size_t channel) -> int64_t {
    return sound.samples[std::min(index, length - 1) * channels + std::min(channel, channels - 1)];
  };
  const auto from = static_cast<uint64_t>(sound.rate_hz);
  const auto to = static_cast<uint64_t>(rate_hz);
  std::vector<OSoundSampleStereo16> stereo(length * to / from);
  for (size_t i = 0; i < stereo.size(); ++i) {
    const size_t index = i * from / to;
    const auto part = static_cast<int64_t>(i * from % to);
    const auto mixed = [&](size_t channel) {
      const int64_t a = at(index, channel), b = at(index + 1, channel);
      return static_cast<sword>(a + (b - a) * part / static_cast<int64_t>(to));
    };
    stereo[i] = {mixed(0), mixed(1)};
  }
  return stereo;
}

}  // namespace openr_host
