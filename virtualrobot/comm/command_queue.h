// CommandQueue: plays the command vectors that one subject (the sending end of a connection) has
// sent to the robot's Effector service, one after the other.
//
// A command vector has an element for each joint, light or ear that it sets, and each element has
// up to 16 command frames.  A command frame of a joint lasts one robot frame of 8 ms.  A command
// frame of a light lasts as long as its member `period` says.  A command frame of an ear lasts
// 128 ms; on an ERS-7, it has a member `period`, too (robot.md, sections 9.4 and 10).  A vector
// lasts as long as its longest element; shorter elements hold their last value.  The next vector
// starts in the frame after the last frame of the vector before.
#pragma once

#include <OPENR/ODataFormats.h>
#include <OPENR/ObjcommTypes.h>
#include <OPENR/RCRegion.h>

#include <cstdint>
#include <deque>
#include <string>
#include <vector>

#include "virtualrobot/devices/command_vector.h"
#include "virtualrobot/vectors/region_reference.h"
#include "virtualrobot/vectors/vector_turn.h"

namespace openr_host {

class Hasher;
struct RobotParts;

class CommandQueue {
 public:
  // Largest number of vectors that may wait.  The limit of the robot is not known; Sony's samples
  // need four.
  static constexpr size_t kMax = 32;

  // Makes a queue for the vectors of `subject`, which move the parts of `robot`.  `robot` must
  // outlive the queue.
  CommandQueue(const SubjectID& subject, RobotParts* robot) : subject_(subject), robot_(robot) {}

  const SubjectID& subject() const { return subject_; }

  // Appends the command vector in `region` to the queue.  The queue holds a reference to the region
  // until the vector is over.  Returns false when the queue is full.
  bool Add(RCRegion* region);

  // If the vector that plays is over when frame `frame` begins, releases its region and returns
  // true.  Otherwise returns false.
  bool ReleaseFinished(int64_t frame);

  // If no vector plays, tells the robot's SyncKeys that the first waiting vector can start now.
  // Vectors in different queues can have the same synchronisation key; these vectors start
  // together, in the frame in which the last of them can start.  REQUIRES: called for all queues of
  // a robot before Apply() of any of them.  Otherwise such vectors could start in different frames.
  void AnnounceFirst();

  // Starts the first waiting vector if no vector plays, and if the synchronisation key of the
  // waiting vector (if there is a key) allows the start.  Then applies the set points of frame
  // `frame`.  Adds to `problems` a text for each mistake in a vector that starts.
  void Apply(int64_t frame, std::vector<std::string>* problems);

  void HashState(Hasher* hasher) const;

 private:
  struct Element {
    CommandElement command;
    int command_frame = 0;
    int64_t ends = 0;  // the robot frame in which the present command frame is over
  };

  void Start(int64_t frame, std::vector<std::string>* problems);
  void FindFace(std::vector<std::string>* problems);

  SubjectID subject_;
  RobotParts* robot_;
  std::deque<RegionReference> waiting_;
  VectorTurn turn_;          // tells when the first vector in waiting_ may start
  RegionReference playing_;  // the vector that plays; empty when none plays
  int64_t start_ = 0;        // frame in which the vector in playing_ begins
  int64_t end_ = 0;          // first frame after the vector in playing_
  std::vector<Element> elements_;
  // The elements that Start() has read.  It is a member and no local variable, so that Start() does
  // not allocate memory for each vector.
  std::vector<CommandElement> read_;
  int face_ = -1;  // index of the element with the last light of the face; -1: no such light
};

}  // namespace openr_host
