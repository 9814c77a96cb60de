// The speaker with the settings of ControlPrimitive(): mute, volume, type of sound.
#pragma once

#include <OPENR/OPrimitiveControl.h>

#include <cstdint>
#include <memory>
#include <string>
#include <utility>

#include "virtualrobot/sound/sound_sink.h"

namespace openr_host {

class Hasher;

// A type of sound that the speaker plays: 8 kHz with 8 bits or 16 kHz with 16 bits, mono, signed.
struct SoundType {
  longword type;
  int bytes_per_sample;
  int samples_per_frame;  // 8 ms
  int rate_hz() const { return samples_per_frame * 125; }
  int bytes_per_vector() const { return 4 * samples_per_frame * bytes_per_sample; }  // 32 ms
};

class Speaker {
 public:
  // Null as `sink`: the sound is lost.
  explicit Speaker(std::unique_ptr<SoundSink> sink) : sink_(std::move(sink)) {}

  void set_mute(bool mute) { mute_ = mute; }

  // `volume` has the unit of ospkvol10dB and the other constants of that name: 1/256 dB, as a two's
  // complement of 16 bits.
  void SetVolume(longword volume);
  longword volume() const { return volume_; }

  // Returns false, and keeps the old type, when `type` is reserved or unknown.
  bool SetSoundType(longword type);
  const SoundType& sound_type() const { return *type_; }

  // Plays one frame.  It is silent without motor power, because the amplifier has its power from
  // the motors' supply (inferred from the order of calls in Sony's SoundPlay).  Returns "" or why
  // the sound could not be written.
  std::string Play(int64_t frame, const SoundFrame& samples, bool motor_power);

  // Tells that no more sound comes.  Returns "" or why not all sound could be written.
  std::string Close() { return sink_ == nullptr ? "" : sink_->Close(); }

  void HashState(Hasher* hasher) const;

 private:
  std::unique_ptr<SoundSink> sink_;
  bool mute_ = false;
  longword volume_ = ospkvol10dB;  // value at boot; chosen
  int32_t gain_ = kFullGain;       // factor of volume_, times kFullGain
  const SoundType* type_ = FindSoundType(ospksndMONO8K8B);

  static constexpr int32_t kFullGain = 1 << 12;
  static const SoundType* FindSoundType(longword type);
};

}  // namespace openr_host
