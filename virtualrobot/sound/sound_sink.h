// Receivers of the sound that the speaker plays: a file or memory.
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

namespace openr_host {

// Rate, in Hz, of the sound that a sink receives.  A sink receives every sample of a sound of 8 kHz
// twice, so that every sound has this rate.
constexpr int kSoundRate = 16'000;
constexpr int kSoundSamplesPerFrame = 128;  // number of samples in a frame (8 ms)

// Samples of one frame of 8 ms, mono.
using SoundFrame = std::array<int16_t, kSoundSamplesPerFrame>;

class SoundSink {
 public:
  virtual ~SoundSink() = default;

  // Stores the sound of frame `frame`.  Frames count from the first boot, and later boots continue
  // the count.  Each call is for a later frame than the call before; frames that are left out are
  // silent.  Returns "", or the reason why the sound could not be written.
  virtual std::string Play(int64_t frame, const SoundFrame& samples) = 0;

  // Ends the sound after its last frame.  Returns "", or the reason why some of the sound could not
  // be written.
  virtual std::string Close() { return ""; }
};

// A sink that keeps the sound of all frames in memory.
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

// Opens a sink that writes the WAV file `file`: 16 kHz, 16 bits, mono.  The time of the file is the
// virtual time since the first boot, without the time in which the robot was off.  The file is
// complete after every frame, so it can be read even if the process is killed.  Throws
// std::runtime_error with the text "FILE: cannot be written: reason".
std::unique_ptr<SoundSink> OpenSpeakerFile(const std::string& file);

}  // namespace openr_host
