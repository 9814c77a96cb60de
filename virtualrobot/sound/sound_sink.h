// Receivers of the sound that the speaker plays: a file, memory.
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

namespace openr_host {

constexpr int kSoundRate = 16'000;          // Hz; of 8 kHz sound every sample is played twice
constexpr int kSoundSamplesPerFrame = 128;  // 8 ms of it

// Samples of one frame of 8 ms, mono.
using SoundFrame = std::array<int16_t, kSoundSamplesPerFrame>;

class SoundSink {
 public:
  virtual ~SoundSink() = default;

  // Takes the sound of frame `frame` since boot.  Each call is for a later frame than the one
  // before; frames that are left out are silent.  Returns "" or why the sound could not be written.
  virtual std::string Play(int64_t frame, const SoundFrame& samples) = 0;

  // Tells that no more sound comes.  Returns "" or why not all sound could be written.
  virtual std::string Close() { return ""; }
};

// Keeps all frames in memory.
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

// Writes a WAV file, 16 kHz, 16 bits, mono, in which time is the virtual time since boot.  The file
// is complete after every frame, so it can be read even if the process is killed.  Throws
// std::runtime_error "FILE: cannot be written: why".
std::unique_ptr<SoundSink> OpenSpeakerFile(const std::string& file);

}  // namespace openr_host
