#include "virtualrobot/sound/sound_source.h"

#include "virtualrobot/sound/sound_sink.h"
#include "virtualrobot/sound/wav_file.h"

namespace openr_host {

void MemorySoundSource::Read(int64_t first, OSoundSampleStereo16* samples, int count) {
  const auto length = static_cast<int64_t>(samples_.size());
  for (int i = 0; i < count; ++i) {
    int64_t at = first + i;
    if (after_end_ == AfterEnd::kLoop && length > 0) at %= length;
    samples[i] = at < length ? samples_[static_cast<size_t>(at)] : OSoundSampleStereo16{0, 0};
  }
}

std::unique_ptr<SoundSource> OpenMicrophoneFile(const std::string& file, AfterEnd after_end) {
  return std::make_unique<MemorySoundSource>(ToStereo(ReadWavFile(file), kSoundRate), after_end);
}

}  // namespace openr_host
