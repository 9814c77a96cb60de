// The speaker as ControlPrimitive() sets it: mute, volume, kind of sound.
#pragma once

#include <OPENR/OPrimitiveControl.h>

#include <cstdint>
#include <memory>
#include <string>
#include <utility>

#include "virtualrobot/sound/sound_sink.h"

namespace openr_host {

class Hasher;

// A kind of sound the speaker plays: 8 kHz of 8 bits or 16 kHz of 16 bits, mono, signed.
struct SoundType {
  longword type;
  int bytes_per_sample;
  int samples_per_frame;  // 8 ms
  int rate_hz() const { return samples_per_frame * 125; }
  int bytes_per_vector() const { return 4 * samples_per_frame * bytes_per_sample; }  // 32 ms
};

class Speaker {
 public:
  // Without a sink the sound goes nowhere.
  explicit Speaker(std::unique_ptr<SoundSink> sink) : sink_(std::move(sink)) {}

  void set_mute(bool mute) { mute_ = mute; }

  // `volume` counts as ospkvol10dB and its kin do: 16 bits, two's complement, 1/256 dB.
  void SetVolume(longword volume);
  longword volume() const { return volume_; }

  // False for a kind that is reserved or unknown.
  bool SetSoundType(longword type);
  const SoundType& sound_type() const { return *type_; }

  // Puts out one frame.  The amplifier has its power from the motors' supply (inferred
  // from the order of calls in Sony's SoundPlay).  What the sink could not do.
  std::string Play(int64_t frame, const SoundFrame& samples, bool motor_power);

  // No more is put out; what the sink could not do.
  std::string Close() { return sink_ == nullptr ? "" : sink_->Close(); }

  void HashState(Hasher* hasher) const;

 private:
  std::unique_ptr<SoundSink> sink_;
  bool mute_ = false;
  longword volume_ = ospkvol10dB;  // at boot; chosen
  int32_t gain_ = kFullGain;       // of volume_, over kFullGain
  const SoundType* type_ = FindSoundType(ospksndMONO8K8B);

  static constexpr int32_t kFullGain = 1 << 12;
  static const SoundType* FindSoundType(longword type);
};

}  // namespace openr_host
