// Where the speaker's sound goes: nowhere, a file, memory.  The seam to real audio.
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

namespace openr_host {

constexpr int kSoundRate = 16'000;          // Hz; 8 kHz sound is played with every sample twice
constexpr int kSoundSamplesPerFrame = 128;  // 8 ms of it

// Samples of one frame of 8 ms, mono.
using SoundFrame = std::array<int16_t, kSoundSamplesPerFrame>;

class SoundSink {
 public:
  virtual ~SoundSink() = default;

  // What sounds during frame `frame` since boot.  Frames rise; those left out are silent.
  // Empty, or why it could not be written.
  virtual std::string Play(int64_t frame, const SoundFrame& samples) = 0;

  // No more will sound.  Empty, or why not all could be written.
  virtual std::string Close() { return ""; }
};

// Keeps everything, by frame.
class MemorySoundSink : public SoundSink {
 public:
  struct Entry {
    int64_t frame;
    SoundFrame samples;
  };
  std::string Play(int64_t frame, const SoundFrame& samples) override {
    entries.push_back({frame, samples});
    return "";
  }
  std::vector<Entry> entries;
};

// A WAV file, 16 kHz, 16 bits, mono, in which time is the virtual time since boot.  The file is
// complete after every frame, so it can be read even if the process is killed.  Throws
// std::runtime_error "FILE: cannot be written: why".
std::unique_ptr<SoundSink> OpenSpeakerFile(const std::string& file);

}  // namespace openr_host
