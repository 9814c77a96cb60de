// The robot's speaker, with the settings that ControlPrimitive() changes: mute, volume and type of
// sound.
#pragma once

#include <OPENR/OPrimitiveControl.h>

#include <cstdint>
#include <memory>
#include <string>
#include <utility>

#include "virtualrobot/sound/sound_sink.h"

namespace openr_host {

class Hasher;

// A type of sound that the speaker plays: 8 kHz with 8 bits, or 16 kHz with 16 bits; both are mono
// and signed.
struct SoundType {
  longword type;
  int bytes_per_sample;
  int samples_per_frame;  // number of samples in a frame of 8 ms
  int rate_hz() const { return samples_per_frame * 125; }
  // Returns the number of bytes of sound in a vector that lasts 32 ms.
  int bytes_per_vector() const { return 4 * samples_per_frame * bytes_per_sample; }
};

class Speaker {
 public:
  // Makes a speaker that plays to `sink`; null means that sounds are lost.
  explicit Speaker(std::unique_ptr<SoundSink> sink) : sink_(std::move(sink)) {}

  void set_mute(bool mute) { settings_.mute = mute; }

  // Sets the volume.  The unit of `volume` is 1/256 dB, as a two's complement of 16 bits, like the
  // constants ospkvol10dB and others.
  void SetVolume(longword volume);
  longword volume() const { return settings_.volume; }

  // Sets the type of the sound that follows.  Returns false, and keeps the old type, when `type` is
  // reserved or unknown.
  bool SetSoundType(longword type);
  const SoundType& sound_type() const { return *settings_.type; }

  // Plays the sound of frame `frame` (8 ms).  The frame is silent when `motor_power` is false,
  // because the amplifier has its power from the motors' supply (inferred from the order of calls
  // in Sony's sample SoundPlay).  Returns "", or the reason why the sound could not be written.
  std::string Play(int64_t frame, const SoundFrame& samples, bool motor_power);

  // The newest frame of sound as the loudspeaker gives it: with the volume applied, and silent
  // while the speaker is muted or has no power.  Listeners outside of the run, such as ROS topics,
  // get this sound.
  struct Sound {
    // Number of the frame in which the sound was played; -1: no sound was played yet.  The frames
    // in which the robot is on are counted from its first boot.
    int64_t frame = -1;
    SoundFrame samples{};
  };
  const Sound& newest() const { return newest_; }

  // Resets the settings to their values at boot, because the robot is switched off in frame
  // `frame`.  After the next boot, Play() gets frame numbers that begin at 0 again.  The sink (the
  // file or device of the sound) must get numbers that go on, so counts the frames before the boot.
  void SwitchOff(int64_t frame) {
    settings_ = {};
    frames_before_boot_ += frame;
  }

  // Closes the sink after the last sound.  Returns "", or the reason why some of the sound could
  // not be written.
  std::string Close() { return sink_ == nullptr ? "" : sink_->Close(); }

  void HashState(Hasher* hasher) const;

 private:
  static constexpr int32_t kFullGain = 1 << 12;
  static const SoundType* FindSoundType(longword type);

  struct Settings {
    bool mute = false;
    longword volume = ospkvol10dB;  // the volume at boot is our choice
    int32_t gain = kFullGain;       // factor that `volume` stands for, times kFullGain
    const SoundType* type = FindSoundType(ospksndMONO8K8B);
  };

  std::unique_ptr<SoundSink> sink_;
  Settings settings_;
  Sound newest_;
  // number of frames before the last boot in which the robot was on
  int64_t frames_before_boot_ = 0;
};

}  // namespace openr_host
