#include "virtualrobot/comm/sound_queue.h"

#include <fmt/format.h>

#include <algorithm>

#include "runtime/base/assert.h"
#include "runtime/base/hasher.h"
#include "virtualrobot/robot/robot_parts.h"
#include "virtualrobot/vectors/frame_number.h"

namespace openr_host {
namespace {

// Returns the reason why the speaker does not play the sound of `info`; "" when the speaker plays
// it.
std::string PlayProblem(const OSoundInfo& info, const Primitive* primitive) {
  if (primitive == nullptr || primitive->type != oprimitiveSPEAKER || !primitive->opened()) {
    return fmt::format("names primitive {:#x}, which {}", info.primitiveID,
                       primitive == nullptr                   ? "the robot does not have"
                       : primitive->type != oprimitiveSPEAKER ? "is no speaker"
                                                              : "nobody opened");
  }
  if (info.type != odataSOUND && info.type != odataSOUND_VECTOR)
    return fmt::format("has data type {}; odataSOUND is {}", info.type, odataSOUND);
  if (info.format != osoundformatUNDEF && info.format != osoundformatPCM)
    return fmt::format("has format {}; only PCM ({}) is played", info.format, osoundformatPCM);
  return "";
}

// Returns a warning if `info` names a rate, sample size or number of channels that differs from the
// speaker's settings; otherwise "".
std::string FormatWarning(const OSoundInfo& info, const SoundType& type) {
  // Gives no warning about a field that is 0, because 0 means that the program did not set it.
  const auto differs = [](word named, int set) { return named != 0 && named != set; };
  if (!differs(info.samplingRate, type.rate_hz()) &&
      !differs(info.bitsPerSample, 8 * type.bytes_per_sample) && !differs(info.channel, 1))
    return "";
  return fmt::format(
      "says {} Hz, {} bits, {} channels; the speaker is set to {} Hz, {} bits, mono and plays it "
      "as "
      "that (oprmreqSPEAKER_SET_SOUND_TYPE)",
      info.samplingRate, info.bitsPerSample, info.channel, type.rate_hz(),
      8 * type.bytes_per_sample);
}

}  // namespace

bool SoundQueue::Add(RCRegion* region, const SubjectID& subject) {
  if (waiting_.size() >= kMax) return false;
  waiting_.push_back({RegionReference(region), subject});
  ASSERT(waiting_.size() <= kMax, "{} vectors wait", waiting_.size());
  return true;
}

std::optional<SubjectID> SoundQueue::ReleaseFinished() {
  if (finished_.empty()) return std::nullopt;
  const SubjectID subject = finished_.front().subject;
  finished_.pop_front();
  return subject;
}

void SoundQueue::AnnounceFirst() {
  if (!playing_.region && !waiting_.empty())
    turn_.Announce(SyncKeyOf(*waiting_.front().region), &robot_.sync_keys);
}

void SoundQueue::ReadSound(const SentVector& vector, int index, longword frame_number,
                           std::vector<std::string>* problems) {
  OSoundInfo& info = reinterpret_cast<OSoundVectorData*>(vector.header)->info[index];
  const SoundType& type = robot_.speaker.sound_type();
  info.frameNumber = frame_number;
  // Plays only the bytes for which the vector has room, because the size in `info` may be wrong.
  size_t bytes = info.dataSize;
  if (bytes > info.maxDataSize || vector.At(info.dataOffset, bytes) == nullptr) {
    const size_t room = info.dataOffset > vector.bytes ? 0 : vector.bytes - info.dataOffset;
    bytes = std::min<size_t>({bytes, info.maxDataSize, room});
    problems->push_back(
        fmt::format("sound vector: says {} bytes, has room for {}; the rest is "
                    "ignored",
                    info.dataSize, bytes));
  }
  std::string problem = PlayProblem(info, robot_.primitives.Find(info.primitiveID));
  const bool audible = problem.empty();
  if (!audible) {
    problem += "; it is silent and takes its time";
  } else {
    problem = FormatWarning(info, type);
  }
  if (!problem.empty()) problems->push_back("sound vector: it " + problem);
  Sound sound;
  sound.bytes_per_sample = type.bytes_per_sample;
  // Plays each sample of a sound with a lower rate more than once, because a frame always has
  // kSoundSamplesPerFrame samples.
  sound.repeat = kSoundSamplesPerFrame / type.samples_per_frame;
  sound.data = audible ? reinterpret_cast<const byte*>(vector.At(info.dataOffset, bytes)) : nullptr;
  sound.samples = static_cast<int64_t>(bytes) / type.bytes_per_sample * sound.repeat;
  info.actualDataSize = audible ? static_cast<longword>(bytes) : 0;
  if (sound.samples > 0) sounds_.push_back(sound);
}

void SoundQueue::Start(int64_t frame, bool behind_another, std::vector<SoundProblem>* problems) {
  ASSERT(!playing_.region, "a sound vector starts while another one plays");
  playing_ = std::move(waiting_.front());
  waiting_.pop_front();
  turn_.Next();
  sounds_.clear();
  sound_ = 0;
  position_ = 0;
  std::vector<std::string> found;
  const SentVector vector = ReadSentVector(playing_.region.get(), sizeof(OSoundInfo),
                                           "sound vector", robot_.system, &found);
  const int64_t wait = WaitOf(vector, &found);
  // Without a delay, the sound vector begins in `frame`: at the beginning of this frame, or
  // directly after another vector that has ended in the middle of it.  With a delay, the sound
  // vector waits `wait` whole frames.  The first of these is `frame`, or the next frame if another
  // vector was played in `frame`.
  start_ = wait == 0 ? frame : frame + (behind_another ? 1 : 0) + wait;
  if (vector.header != nullptr && !NamesItsMemory(vector, robot_.system)) {
    found.push_back(fmt::format(
        "OSpeakerObserver::DoneWriteAsync() error {} (oINVALID_DATA_VECTOR_ID): memRegionID of the "
        "sound vector is {:#x}, it came in {:#x} (made without NewSoundVectorData(), or its header "
        "copied); it is not played",
        oINVALID_DATA_VECTOR_ID, vector.header->memRegionID, playing_.region->MemID()));
  } else if (vector.header != nullptr) {
    robot_.optional.CopyFrom(*vector.header, &found);
    for (int i = 0; i < vector.elements; ++i) ReadSound(vector, i, FrameNumber(start_), &found);
  }
  for (std::string& text : found) problems->push_back({playing_.subject, std::move(text)});
}

int SoundQueue::Copy(int from, SoundFrame* samples) {
  const Sound& sound = sounds_[sound_];
  const int end =
      static_cast<int>(std::min<int64_t>(kSoundSamplesPerFrame, from + sound.samples - position_));
  ASSERT(end > from && end <= kSoundSamplesPerFrame, "{} to {}", from, end);
  for (int i = from; i < end; ++i, ++position_) {
    if (sound.data == nullptr) continue;
    const byte* const at = sound.data + position_ / sound.repeat * sound.bytes_per_sample;
    const int value = sound.bytes_per_sample == 1 ? at[0] << 8 : at[0] | at[1] << 8;
    (*samples)[static_cast<size_t>(i)] = static_cast<int16_t>(value);
  }
  if (position_ == sound.samples) {
    ++sound_;
    position_ = 0;
  }
  return end;
}

bool SoundQueue::Fill(int64_t frame, SoundFrame* samples, std::vector<SoundProblem>* problems) {
  samples->fill(0);
  bool played = false;
  std::vector<std::string> waiting_problems;
  for (int filled = 0; filled < kSoundSamplesPerFrame;) {
    if (!playing_.region) {
      if (waiting_.empty()) break;
      const QueuedVector& head = waiting_.front();
      const bool may_start =
          turn_.MayStart(SyncKeyOf(*head.region), robot_.sync_keys, &waiting_problems);
      for (std::string& text : waiting_problems)
        problems->push_back({head.subject, std::move(text)});
      if (!may_start) break;
      Start(frame, filled > 0, problems);
    }
    if (frame < start_) break;
    if (sound_ < sounds_.size()) {
      filled = Copy(filled, samples);
      played = true;
    } else {
      // Leaves the rest of this frame silent, because a vector without sound lasts until the end of
      // the frame in which it begins.
      filled = kSoundSamplesPerFrame;
    }
    if (sound_ < sounds_.size()) continue;
    finished_.push_back(std::move(playing_));
  }
  return played;
}

void SoundQueue::Clear() {
  waiting_.clear();
  finished_.clear();
  playing_ = {};
  sounds_.clear();
}

void SoundQueue::HashState(Hasher* hasher) const {
  hasher->Add(static_cast<uint64_t>(waiting_.size()));
  for (const QueuedVector& sent : waiting_) hasher->Add(sent.region->MemID());
  hasher->Add(turn_.announced());
  hasher->Add(playing_.region ? playing_.region->MemID() : 0);
  for (const Sound& sound : sounds_) {
    // Hashes only whether the sound has data, and not the address of the data, because addresses
    // differ between runs.
    hasher->Add(sound.data != nullptr);
    hasher->Add(sound.samples);
    hasher->Add(sound.repeat);
  }
  hasher->Add(start_);
  hasher->Add(static_cast<uint64_t>(sound_));
  hasher->Add(position_);
  hasher->Add(static_cast<uint64_t>(finished_.size()));
}

}  // namespace openr_host
