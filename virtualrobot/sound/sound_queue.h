// The sound vectors that were sent to the speaker: one queue for all subjects, in the order of
// arrival. Vectors that wait are played without a gap between their samples.
//
// A vector that comes to an empty queue begins with the next frame of 8 ms.  It is over with the
// frame in which its last sample sounds; then its subject gets a ready (Level 2 Reference
// Guide, 3.2).  A vector without sound, or one that is refused, takes one frame.
#pragma once

#include <OPENR/ODataFormats.h>
#include <OPENR/ObjcommTypes.h>

#include <deque>
#include <optional>
#include <string>
#include <vector>

#include "virtualrobot/region_reference.h"
#include "virtualrobot/sound/speaker.h"
#include "virtualrobot/vector_memory.h"
#include "virtualrobot/vector_turn.h"

namespace openr_host {

class Hasher;
struct RobotParts;

// A mistake in a sound vector, and the subject that sent it.
struct SoundProblem {
  SubjectID subject;
  std::string text;
};

class SoundQueue {
 public:
  // Vectors that may wait.  The number of the robot is not known; Sony's samples need two.
  static constexpr size_t kMax = 32;

  // For vectors that the speaker of `robot` plays.  `robot` must outlive the queue.
  explicit SoundQueue(RobotParts* robot) : robot_(*robot) {}

  // Appends the vector in `region`, sent by `subject`, and refers to the region until the vector is
  // over.  Returns false when the queue is full.
  bool Add(RCRegion* region, const SubjectID& subject);

  // Releases the region of the oldest vector that was over before the frame that begins, and
  // returns the vector's subject; nothing when there is no such vector.
  std::optional<SubjectID> ReleaseFinished();

  // Tells the synchronisation keys of the robot when a vector with a key has become the first that
  // waits.  REQUIRES: called before Fill() and before command vectors of the frame start.
  void AnnounceFirst();

  // Starts vectors that are due and fills in the samples of frame `frame`.  Returns false when no
  // vector plays.  Adds to `problems` the mistakes of vectors that start.
  bool Fill(int64_t frame, SoundFrame* samples, std::vector<SoundProblem>* problems);

  bool busy() const { return !waiting_.empty() || !finished_.empty() || playing_.region; }
  void HashState(Hasher* hasher) const;

 private:
  struct Sent {
    RegionReference region;
    SubjectID subject;
  };

  // A sound of the vector that plays.
  struct Sound {
    const byte* data;  // null: silence
    int64_t samples;   // length at the rate of the sink
    int bytes_per_sample;
    int repeat;  // samples for the sink from each sample of the data
  };

  // Starts the first vector that waits.  `behind_another` says that another vector ended in this
  // frame; then the frames of a wait begin with the next frame.
  void Start(int64_t frame, bool behind_another, std::vector<SoundProblem>* problems);
  void ReadSound(const SentVector& vector, int index, longword frame_number,
                 std::vector<std::string>* problems);
  // Fills in samples of the present sound from `samples[from]` on.  Returns the index after the
  // last one.
  int Copy(int from, SoundFrame* samples);

  RobotParts& robot_;
  std::deque<Sent> waiting_;
  VectorTurn turn_;  // state of the first vector in waiting_
  Sent playing_;     // without a region when no vector plays
  int64_t start_ = 0;
  std::vector<Sound> sounds_;
  size_t sound_ = 0;      // index of the sound that plays
  int64_t position_ = 0;  // sample of that sound that is next
  std::deque<Sent> finished_;
};

}  // namespace openr_host
