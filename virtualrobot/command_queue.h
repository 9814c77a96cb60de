// Command vectors of one subject of the Effector: played one after the other.
//
// A vector is as long as its longest element.  A joint frame lasts 8 ms, an LED frame
// its period, an ear frame 128 ms; shorter elements hold their last value (robot.md,
// sections 9.4 and 10).  The next vector starts on the frame after the last one.
#pragma once

#include <OPENR/ODataFormats.h>
#include <OPENR/RCRegion.h>

#include <deque>
#include <string>
#include <vector>

#include "virtualrobot/command_vector.h"
#include "virtualrobot/region_reference.h"
#include "virtualrobot/vector_turn.h"

namespace openr_host {

class Hasher;
class JointWatch;
class OptionalBytes;
class SyncKeys;
class System;

// What vectors act on and what they are checked against.
struct EffectorPort {
  PrimitiveTable* primitives = nullptr;
  Devices* devices = nullptr;
  SyncKeys* sync_keys = nullptr;
  OptionalBytes* optional = nullptr;
  JointWatch* watch = nullptr;
  System* system = nullptr;
  const BodyState* body = nullptr;
  bool motor_power = false;
  bool motor_power_cut = false;  // by the pause button
};

class CommandQueue {
 public:
  // Vectors that may wait; the robot's number is not known, samples need four.
  static constexpr size_t kMax = 32;

  // Appends the vector in `region` and refers to the region until the vector is over.  Returns
  // false when the queue is full.
  bool Add(RCRegion* region);

  // Releases the region of a vector that is over before frame `frame` begins.  Returns false when
  // there is no such vector.
  bool ReleaseFinished(int64_t frame);

  // Starts what is due and applies the set points of frame `frame`.  What is wrong with a
  // vector that starts is described in `problems`.
  void Apply(int64_t frame, const EffectorPort& port, std::vector<std::string>* problems);

  // Tells the keys when a vector that carries one has come to the head.  For all
  // queues of a robot before the first Apply() of a frame.
  void Announce(SyncKeys* sync_keys);

  void HashState(Hasher* hasher) const;

 private:
  struct Element {
    CommandElement command;
    int command_frame = 0;
    int64_t ends = 0;  // first robot frame after the current command frame
  };

  void Start(int64_t frame, const EffectorPort& port, std::vector<std::string>* problems);
  void FindFace(const Devices& devices, std::vector<std::string>* problems);

  std::deque<RegionReference> waiting_;
  VectorTurn turn_;  // of the first that waits
  RegionReference playing_;
  int64_t start_ = 0;  // frame in which it begins
  int64_t end_ = 0;    // first frame after it
  std::vector<Element> elements_;
  std::vector<CommandElement> read_;  // used by Start() only
  int face_ = -1;                     // element of the last light of the face; -1: none
};

}  // namespace openr_host
