// The two microphones of the robot: 16 kHz, 16 bits, stereo, one vector every 32 ms (ERS-7: 16 ms).
#pragma once

#include <OPENR/RCRegion.h>

#include <cstdint>
#include <memory>

#include "virtualrobot/primitive_table.h"
#include "virtualrobot/sound/sound_source.h"
#include "virtualrobot/vector_memory.h"

namespace openr_host {

class Hasher;

class Microphone {
 public:
  // Null as `source` is silence.  REQUIRES: frames_per_vector > 0.
  Microphone(std::unique_ptr<SoundSource> source, OPrimitiveID id, int frames_per_vector);

  // Settings of the requests oprmreqMIC_*.  They do not change the sound, because it is not known
  // what they do on the robot.
  void set_directional(bool directional) { directional_ = directional; }
  void set_level_control(bool on) { level_control_ = on; }

  // Whether a vector is complete when frame `frame` begins.
  bool Due(int64_t frame) const { return frame > 0 && frame % frames_per_vector_ == 0; }

  // A vector with the frames before `frame`, in a region to which no object refers.  The one
  // reference to the region stays here.  REQUIRES: Due(frame).  Runs as code of an object.
  RCRegion* MakeVector(int64_t frame);

  void HashState(Hasher* hasher) const;

 private:
  RCRegion* FreeVector();

  std::unique_ptr<SoundSource> source_;
  const OPrimitiveID id_;
  const int frames_per_vector_;
  bool directional_ = false;  // values at boot; chosen
  bool level_control_ = false;
  VectorPool pool_;
};

}  // namespace openr_host
