#include "virtualrobot/sound/speaker.h"

#include <algorithm>

#include "runtime/base/hasher.h"

namespace openr_host {
namespace {

constexpr SoundType kSoundTypes[] = {
    {ospksndMONO8K8B, 1, 64},
    {ospksndMONO16K16B, 2, 128},
};

// Factors of the volume for -1 dB and for -1/256 dB.  They are constants, because results of libm's
// pow() differ between machines.
constexpr double kOneDecibel = 0.8912509381337456;
constexpr double kOneStep = 0.9995503774595479;

constexpr sword Signed(longword volume) { return static_cast<sword>(volume & 0xffff); }

// Returns the factor by which samples are multiplied at the volume `volume`.  The factor is 1 at
// -10 dB, because this is the highest volume for which the circuit of the robot is made.
double GainOf(longword volume) {
  if ((volume & 0xffff) == ospkvolinfdB) return 0;
  int below = Signed(ospkvol10dB) - Signed(volume);  // distance below -10 dB, in 1/256 dB
  double gain = 1;
  for (; below >= 256; below -= 256) gain *= kOneDecibel;
  for (; below > 0; --below) gain *= kOneStep;
  for (; below <= -256; below += 256) gain /= kOneDecibel;
  for (; below < 0; ++below) gain /= kOneStep;
  return gain;
}

}  // namespace

const SoundType* Speaker::FindSoundType(longword type) {
  for (const SoundType& known : kSoundTypes) {
    if (known.type == type) return &known;
  }
  return nullptr;
}

void Speaker::SetVolume(longword volume) {
  settings_.volume = volume & 0xffff;
  // Limits the factor of the volume to 1000 (60 dB), because beyond it every sample is at full
  // scale anyway.
  settings_.gain = static_cast<int32_t>(std::min(GainOf(settings_.volume), 1000.0) * kFullGain);
}

bool Speaker::SetSoundType(longword type) {
  const SoundType* const found = FindSoundType(type);
  if (found == nullptr) return false;
  settings_.type = found;
  return true;
}

std::string Speaker::Play(int64_t frame, const SoundFrame& samples, bool motor_power) {
  SoundFrame& out = newest_.samples;
  out.fill(0);
  if (motor_power && !settings_.mute) {
    for (size_t i = 0; i < samples.size(); ++i) {
      out[i] = static_cast<int16_t>(std::clamp(int64_t{samples[i]} * settings_.gain / kFullGain,
                                               int64_t{INT16_MIN}, int64_t{INT16_MAX}));
    }
  }
  newest_.frame = frames_before_boot_ + frame;
  return sink_ == nullptr ? "" : sink_->Play(newest_.frame, out);
}

void Speaker::HashState(Hasher* hasher) const {
  hasher->Add(settings_.mute);
  hasher->Add(settings_.volume);
  hasher->Add(settings_.type->type);
}

}  // namespace openr_host
