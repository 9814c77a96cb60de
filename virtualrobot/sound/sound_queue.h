// Sound vectors that wait for the speaker: one queue for all subjects, in the order of
// their arrival, played without a gap, sample after sample.
//
// A vector that finds nothing before it begins with the next frame of 8 ms.  It is over
// with the frame in which its last sample sounds; then its subject gets its ready (Level 2
// Reference Guide, 3.2).  A vector without sound, or one that is refused, takes one frame.
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

// A problem with a vector, and whose it is.
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

  // The samples of frame `frame`; false when nothing plays.
  bool Fill(int64_t frame, SoundFrame* samples, std::vector<SoundProblem>* problems);

  bool busy() const { return !waiting_.empty() || !finished_.empty() || playing_.region; }
  void HashState(Hasher* hasher) const;

 private:
  struct Sent {
    RegionReference region;
    SubjectID subject;
  };

  // One sound of the vector that plays.
  struct Sound {
    const byte* data;  // null: silence
    int64_t samples;   // of the sink's rate
    int bytes_per_sample;
    int repeat;  // samples of the sink per sample of the data
  };

  // `behind_another`: in the same frame, of which a wait does not count.
  void Start(int64_t frame, bool behind_another, std::vector<SoundProblem>* problems);
  void ReadSound(const SentVector& vector, int index, longword frame_number,
                 std::vector<std::string>* problems);
  // Fills from `samples[from]` on; where it stopped.
  int Copy(int from, SoundFrame* samples);

  RobotParts& robot_;
  std::deque<Sent> waiting_;
  VectorTurn turn_;  // of the first vector in waiting_
  Sent playing_;     // without a region when no vector plays
  int64_t start_ = 0;
  std::vector<Sound> sounds_;
  size_t sound_ = 0;      // that plays
  int64_t position_ = 0;  // in it
  std::deque<Sent> finished_;
};

}  // namespace openr_host
