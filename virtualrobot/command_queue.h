// The command vectors that one subject sent to the Effector, played one after the other.
//
// A vector is as long as its longest element.  A joint frame lasts 8 ms, an LED frame its period,
// an ear frame 128 ms; shorter elements hold their last value (robot.md, sections 9.4 and 10).  The
// next vector starts with the frame after the last one of the vector before.
#pragma once

#include <OPENR/ODataFormats.h>
#include <OPENR/ObjcommTypes.h>
#include <OPENR/RCRegion.h>

#include <cstdint>
#include <deque>
#include <string>
#include <vector>

#include "virtualrobot/command_vector.h"
#include "virtualrobot/region_reference.h"
#include "virtualrobot/vector_turn.h"

namespace openr_host {

class Hasher;
struct RobotParts;

class CommandQueue {
 public:
  // Vectors that may wait.  The number of the robot is not known; Sony's samples need four.
  static constexpr size_t kMax = 32;

  // For vectors of `subject`, which act on `robot`.  `robot` must outlive the queue.
  CommandQueue(const SubjectID& subject, RobotParts* robot) : subject_(subject), robot_(robot) {}

  const SubjectID& subject() const { return subject_; }

  // Appends the vector in `region` and refers to the region until the vector is over.  Returns
  // false when the queue is full.
  bool Add(RCRegion* region);

  // Releases the region of a vector that is over before frame `frame` begins.  Returns false when
  // there is no such vector.
  bool ReleaseFinished(int64_t frame);

  // Tells the synchronisation keys of the robot when a vector with a key has become the first that
  // waits.  REQUIRES: called for all queues of a robot before Apply() of any of them, so that
  // vectors with parts of one key start in the same frame.
  void AnnounceFirst();

  // Starts the first vector that waits when it is due, and puts the set points of frame `frame` in
  // force.  Adds a text to `problems` for each thing that is wrong with a vector that starts.
  void Apply(int64_t frame, std::vector<std::string>* problems);

  void HashState(Hasher* hasher) const;

 private:
  struct Element {
    CommandElement command;
    int command_frame = 0;
    int64_t ends = 0;  // first robot frame after the current command frame
  };

  void Start(int64_t frame, std::vector<std::string>* problems);
  void FindFace(std::vector<std::string>* problems);

  SubjectID subject_;
  RobotParts* robot_;
  std::deque<RegionReference> waiting_;
  VectorTurn turn_;          // state of the first vector in waiting_
  RegionReference playing_;  // the vector that plays, if any
  int64_t start_ = 0;        // frame in which it begins
  int64_t end_ = 0;          // first frame after it
  std::vector<Element> elements_;
  std::vector<CommandElement> read_;  // a local of Start(), kept to save allocations
  int face_ = -1;                     // element with the last light of the face; -1: none
};

}  // namespace openr_host
