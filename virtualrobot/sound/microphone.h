// The two microphones of the robot: 16 kHz, 16 bits, stereo.  A sound vector lasts 32 ms (ERS-7: 16
// ms); a frame is 8 ms.
#pragma once

#include <OPENR/RCRegion.h>

#include <cstdint>
#include <memory>

#include "virtualrobot/devices/primitive_table.h"
#include "virtualrobot/sound/sound_source.h"
#include "virtualrobot/vectors/vector_memory.h"

namespace openr_host {

class Hasher;

class Microphone {
 public:
  // Makes microphones that hear `source`; null means silence.  `id` identifies them in their sound
  // vectors.  REQUIRES: frames_per_vector > 0.
  Microphone(std::unique_ptr<SoundSource> source, OPrimitiveID id, int frames_per_vector);

  // The functions set_directional() and set_level_control() change the settings for which OPEN-R
  // has the requests oprmreqMIC_*.  The settings do not change the sound, because their effect on
  // the robot is not known.
  void set_directional(bool directional) { settings_.directional = directional; }
  void set_level_control(bool on) { settings_.level_control = on; }

  // Returns whether a sound vector of the microphones is complete when frame `frame` begins.
  bool Due(int64_t frame) const { return frame > 0 && frame % frames_per_vector_ == 0; }

  // Returns a vector with the sound of the frames_per_vector frames before `frame`.  The vector is
  // in a free region: only this Microphone holds a reference to it.  REQUIRES: Due(frame) is true,
  // and a handler of an object runs, because a new region belongs to the object that runs.
  RCRegion* MakeVector(int64_t frame);

  // Resets the settings to their values at boot, and gives up the references to the regions of all
  // vectors, because the robot is switched off in frame `frame`.  After the next boot, the numbers
  // of frames begin at 0 again, but the source of sound goes on where it was.  REQUIRES: the object
  // that sends the vectors is the current object.
  void SwitchOff(int64_t frame);

  void HashState(Hasher* hasher) const;

 private:
  RCRegion* FreeVector();

  struct Settings {
    bool directional = false;  // setting of the directional mode; its value at boot is our choice
    bool level_control = false;
  };

  std::unique_ptr<SoundSource> source_;
  const OPrimitiveID id_;
  const int frames_per_vector_;
  Settings settings_;
  // number of frames before the last boot in which the robot was on
  int64_t frames_before_boot_ = 0;
  VectorPool pool_;
};

}  // namespace openr_host
