#include "virtualrobot/sound/microphone.h"

#include "runtime/base/assert.h"
#include "runtime/base/hasher.h"
#include "virtualrobot/sound/sound_sink.h"
#include "virtualrobot/vectors/frame_number.h"

namespace openr_host {

Microphone::Microphone(std::unique_ptr<SoundSource> source, OPrimitiveID id, int frames_per_vector)
    : source_(source ? std::move(source) : std::make_unique<MemorySoundSource>()),
      id_(id),
      frames_per_vector_(frames_per_vector) {
  ASSERT(frames_per_vector > 0, "{} frames", frames_per_vector);
}

RCRegion* Microphone::FreeVector() {
  if (RCRegion* const free = pool_.FindFree()) return free;
  const size_t bytes = sizeof(OSoundSampleStereo16) * kSoundSamplesPerFrame *
                       static_cast<size_t>(frames_per_vector_);
  RCRegion* const region = NewVectorRegion(odataSOUND_VECTOR, sizeof(OSoundInfo), 1, bytes);
  OSoundInfo& info = *reinterpret_cast<OSoundVectorData*>(region->Base())->GetInfo(0);
  info.Set(odataSOUND, id_, bytes);
  info.frameSize = sizeof(OSoundSampleStereo16);
  info.dataOffset = sizeof(ODataVectorInfo) + sizeof(OSoundInfo);
  info.maxDataSize = static_cast<longword>(bytes);
  info.format = osoundformatPCM;
  info.channel = osoundchannelSTEREO;
  info.samplingRate = kSoundRate;
  info.bitsPerSample = 16;
  info.actualDataSize = static_cast<longword>(bytes);
  pool_.Add(region);
  return region;
}

RCRegion* Microphone::MakeVector(int64_t frame) {
  ASSERT(Due(frame), "frame {}", frame);
  RCRegion* const region = FreeVector();
  auto* const vector = reinterpret_cast<OSoundVectorData*>(region->Base());
  const int64_t first = frame - frames_per_vector_;
  vector->GetInfo(0)->frameNumber = FrameNumber(first);
  source_->Read((frames_before_boot_ + first) * kSoundSamplesPerFrame,
                reinterpret_cast<OSoundSampleStereo16*>(vector->GetData(0)),
                frames_per_vector_ * kSoundSamplesPerFrame);
  return region;
}

void Microphone::SwitchOff(int64_t frame) {
  settings_ = {};
  frames_before_boot_ += frame;
  pool_.Clear();
}

void Microphone::HashState(Hasher* hasher) const {
  hasher->Add(settings_.directional);
  hasher->Add(settings_.level_control);
}

}  // namespace openr_host
