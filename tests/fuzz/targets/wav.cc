// The fuzz target wav: WAV files.
#include <stdexcept>

#include "tests/fuzz/fuzz_targets.h"
#include "tests/fuzz/target_list.h"
#include "virtualrobot/sound/wav_file.h"

namespace openr_host {

bool fuzz::wav(std::string_view bytes) {
  const FuzzFile file(bytes);
  try {
    const WavSound sound = ReadWavFile(file.path());
    FuzzCheck(sound.channels == 1 || sound.channels == 2, "the number of channels");
    ToStereo(sound, 16'000);
    return sound.channels == 2 && sound.rate_hz < 4'000;
  } catch (const std::runtime_error&) {
    return false;
  }
}

}  // namespace openr_host
