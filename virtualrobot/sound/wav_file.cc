#include "virtualrobot/sound/wav_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>

#include "virtualrobot/json_reader.h"

namespace openr_host {
namespace {

constexpr uint32_t kPcm = 1;
constexpr uint32_t kExtensible = 0xfffe;  // the format proper is the first word of a GUID
constexpr size_t kExtensibleSize = 40;
constexpr size_t kSubFormat = 24;
constexpr uint32_t kRateMax = 192'000;

// Little-endian number of `size` bytes.
uint32_t Number(std::string_view bytes, size_t at, int size) {
  uint32_t value = 0;
  for (int i = size - 1; i >= 0; --i)
    value = value << 8 | static_cast<uint8_t>(bytes[at + static_cast<size_t>(i)]);
  return value;
}

template <typename... Args>
[[noreturn]] void Fail(const std::string& name, fmt::format_string<Args...> format,
                       Args&&... args) {
  throw std::runtime_error(name + ": " + fmt::format(format, std::forward<Args>(args)...));
}

// The first chunk of that kind behind the RIFF header; empty when there is none.
std::string_view Chunk(std::string_view bytes, std::string_view kind) {
  for (size_t at = 12; at + 8 <= bytes.size();) {
    const size_t size = Number(bytes, at + 4, 4);
    if (bytes.substr(at, 4) == kind) return bytes.substr(at + 8, size);
    at += 8 + size + size % 2;
  }
  return {};
}

void AddNumber(std::string* bytes, uint32_t value, int size) {
  for (int i = 0; i < size; ++i) *bytes += static_cast<char>(value >> 8 * i & 0xff);
}

}  // namespace

WavSound ParseWav(std::string_view bytes, const std::string& name) {
  if (bytes.size() < 12 || bytes.substr(0, 4) != "RIFF" || bytes.substr(8, 4) != "WAVE")
    Fail(name, "is no WAV file");
  const std::string_view format = Chunk(bytes, "fmt ");
  if (format.size() < 16) Fail(name, "has no format chunk");
  uint32_t kind = Number(format, 0, 2);
  if (kind == kExtensible && format.size() >= kExtensibleSize) kind = Number(format, kSubFormat, 2);
  if (kind != kPcm) Fail(name, "holds sound of format {}; only PCM (1) is read", kind);
  const uint32_t channels = Number(format, 2, 2);
  const uint32_t rate = Number(format, 4, 4);
  const uint32_t bits = Number(format, 14, 2);
  if (channels != 1 && channels != 2) Fail(name, "has {} channels; 1 or 2 are read", channels);
  if (bits != 8 && bits != 16) Fail(name, "has {} bits per sample; 8 or 16 are read", bits);
  if (rate == 0 || rate > kRateMax)
    Fail(name, "has {} samples a second; 1 to {} are read", rate, kRateMax);
  const std::string_view data = Chunk(bytes, "data");
  WavSound sound;
  sound.rate_hz = static_cast<int>(rate);
  sound.channels = static_cast<int>(channels);
  const size_t bytes_per_sample = bits / 8;
  const size_t count = data.size() / (bytes_per_sample * channels) * channels;
  sound.samples.reserve(count);
  for (size_t i = 0; i < count; ++i) {
    const uint32_t value = Number(data, i * bytes_per_sample, static_cast<int>(bytes_per_sample));
    sound.samples.push_back(bits == 8 ? static_cast<int16_t>((static_cast<int>(value) - 128) * 256)
                                      : static_cast<int16_t>(value));
  }
  return sound;
}

WavSound ReadWavFile(const std::string& file) { return ParseWav(ReadTextFile(file), file); }

std::vector<OSoundSampleStereo16> ToStereo(const WavSound& sound, int rate_hz) {
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

std::string WavHeader(int rate_hz, uint32_t data_bytes) {
  const auto rate = static_cast<uint32_t>(rate_hz);
  std::string header = "RIFF";
  AddNumber(&header, 36 + data_bytes, 4);
  header += "WAVEfmt ";
  AddNumber(&header, 16, 4);
  AddNumber(&header, kPcm, 2);
  AddNumber(&header, 1, 2);  // channels
  AddNumber(&header, rate, 4);
  AddNumber(&header, rate * 2, 4);  // bytes a second
  AddNumber(&header, 2, 2);         // bytes of a sample on all channels
  AddNumber(&header, 16, 2);        // bits
  header += "data";
  AddNumber(&header, data_bytes, 4);
  return header;
}

}  // namespace openr_host
