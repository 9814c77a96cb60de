// Sources of the sound that the microphone hears: silence, a file, or samples in memory.
#pragma once

#include <OPENR/ODataFormats.h>

#include <cstdint>
#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace openr_host {

class SoundSource {
 public:
  virtual ~SoundSource() = default;

  // Writes `count` stereo samples of 16 kHz to `samples`.  `first` is the number of the first
  // sample.  Samples count from the first boot, and later boots continue the count.  The sample
  // with a given number is always the same, in any order of calls.
  virtual void Read(int64_t first, OSoundSampleStereo16* samples, int count) = 0;
};

// AfterEnd tells what a source plays after its last sample: silence, or the same samples from the
// start again.
enum class AfterEnd { kSilence, kLoop };

// A source that plays samples from memory; silence when there are none.
class MemorySoundSource : public SoundSource {
 public:
  explicit MemorySoundSource(std::vector<OSoundSampleStereo16> samples = {},
                             AfterEnd after_end = AfterEnd::kSilence)
      : samples_(std::move(samples)), after_end_(after_end) {}

  void Read(int64_t first, OSoundSampleStereo16* samples, int count) override;

 private:
  const std::vector<OSoundSampleStereo16> samples_;
  const AfterEnd after_end_;
};

// Opens a source that plays the WAV file `file` (wav_file.h), converted to 16 kHz stereo.  Throws
// std::runtime_error that names the file and says what is wrong with it.
std::unique_ptr<SoundSource> OpenMicrophoneFile(const std::string& file, AfterEnd after_end);

}  // namespace openr_host
