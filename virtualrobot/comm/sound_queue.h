// The sound vectors that were sent to the speaker: one queue for all subjects (senders), in the
// order of arrival.  Waiting vectors are played without a gap between their samples.
//
// A vector that comes to an empty queue begins with the next frame of 8 ms.  The vector is over
// after the frame that plays its last sample; then its subject gets a ready (Level 2 Reference
// Guide, 3.2).  A vector that has no sound, or that the speaker refuses, takes one frame.
#pragma once

#include <OPENR/ODataFormats.h>
#include <OPENR/ObjcommTypes.h>

#include <deque>
#include <optional>
#include <string>
#include <vector>

#include "virtualrobot/sound/speaker.h"
#include "virtualrobot/vectors/region_reference.h"
#include "virtualrobot/vectors/vector_memory.h"
#include "virtualrobot/vectors/vector_turn.h"

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
  // Maximum number of vectors that wait.  The limit of the robot is not known; Sony's samples need
  // two.
  static constexpr size_t kMax = 32;

  // Makes the queue of the speaker of `robot`.  `robot` must outlive the queue.
  explicit SoundQueue(RobotParts* robot) : robot_(*robot) {}

  // Appends the vector in `region`, which `subject` sent.  The queue holds a reference to the
  // region until the vector is over.  Returns false when the queue is full.
  bool Add(RCRegion* region, const SubjectID& subject);

  // Releases the region of the oldest vector that was over before the present frame, and returns
  // the subject of the vector.  Returns nothing when there is no such vector.
  std::optional<SubjectID> ReleaseFinished();

  // Tells the robot's SyncKeys that the first waiting vector could start now, if no vector plays.
  // A program can divide a synchronisation key among several vectors; these vectors start only
  // when all of them could start.  REQUIRES: called before Fill() and before command vectors of the
  // frame start.
  void AnnounceFirst();

  // Starts waiting vectors, if their delays and synchronisation keys allow it, and fills `samples`
  // with the sound of frame `frame`.  Returns false when no sound is played.  Adds to `problems`
  // the mistakes in vectors that start.
  bool Fill(int64_t frame, SoundFrame* samples, std::vector<SoundProblem>* problems);

  // Drops all sound vectors of the queue, and gives up the references to their regions.
  void Clear();

  bool busy() const { return !waiting_.empty() || !finished_.empty() || playing_.region; }
  void HashState(Hasher* hasher) const;

 private:
  struct QueuedVector {
    RegionReference region;
    SubjectID subject;
  };

  // A sound of the vector that plays; a vector may have several.
  struct Sound {
    const byte* data;  // the samples in the vector; null: silence
    int64_t samples;   // number of samples to play, at the rate kSoundRate
    int bytes_per_sample;
    int repeat;  // how many times each sample of `data` is played, to reach the rate kSoundRate
  };

  // Starts the first waiting vector.  `behind_another` says that another vector ended in the same
  // frame.  In this case, if the vector asks for a delay, the delay begins with the next frame.
  void Start(int64_t frame, bool behind_another, std::vector<SoundProblem>* problems);
  void ReadSound(const SentVector& vector, int index, longword frame_number,
                 std::vector<std::string>* problems);
  // Copies samples of the sound that is played now into `samples`, beginning at index `from` of
  // `samples`.  Returns the index after the last sample that was copied.
  int Copy(int from, SoundFrame* samples);

  RobotParts& robot_;
  std::deque<QueuedVector> waiting_;
  VectorTurn turn_;       // tells when the first vector in waiting_ may start
  QueuedVector playing_;  // the vector that plays; its region is empty when none plays
  int64_t start_ = 0;
  std::vector<Sound> sounds_;
  size_t sound_ = 0;      // index of the sound that plays
  int64_t position_ = 0;  // index of the next sample of the sound that plays
  std::deque<QueuedVector> finished_;
};

}  // namespace openr_host
