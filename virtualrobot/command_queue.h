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

#include "virtualrobot/devices.h"
#include "virtualrobot/primitive_table.h"

namespace openr_host {

class Hasher;
class SyncKeys;

// The number that commands, sensors and images carry for the `frame`-th frame since
// boot.  It begins anew after oframeMAX_NUMBER, at 0 (the robot's choice between 0 and
// 1 is not known).
inline longword FrameNumber(int64_t frame) {
  return static_cast<longword>(frame % (int64_t{oframeMAX_NUMBER} + 1));
}

class CommandQueue {
 public:
  // Vectors that may wait; the robot's number is not known, samples need four.
  static constexpr size_t kMax = 32;

  // Takes the region over with the reference the caller added.  False when the
  // queue is full.
  bool Add(RCRegion* region);

  // Ends the vector that is over before frame `frame` begins, if any: its region,
  // whose reference goes to the caller.
  RCRegion* TakeFinished(int64_t frame);

  // Starts what is due and applies the set points of frame `frame`.  Elements that
  // cannot be applied are described in `problems`.
  void Apply(int64_t frame, PrimitiveTable* primitives, Devices* devices, SyncKeys* sync_keys,
             std::vector<std::string>* problems);

  // Tells the keys when a vector that carries one has come to the head.  For all
  // queues of a robot before the first Apply() of a frame.
  void Announce(SyncKeys* sync_keys);

  bool idle() const { return waiting_.empty() && playing_ == nullptr; }
  void HashState(Hasher* hasher) const;

 private:
  struct Element {
    int info = 0;           // index in the vector
    int command_frame = 0;  // of the vector
    int64_t ends = 0;       // first robot frame after the current command frame
    uint32_t length = 0;    // of the whole element, robot frames
    Primitive* primitive = nullptr;
  };

  void Start(int64_t frame, PrimitiveTable* primitives, std::vector<std::string>* problems);
  void ApplyElement(const Element& element, Devices* devices);
  static OCommandVectorData* VectorOf(RCRegion* region) {
    return reinterpret_cast<OCommandVectorData*>(region->Base());
  }
  OCommandVectorData* vector() const { return VectorOf(playing_); }

  std::deque<RCRegion*> waiting_;
  bool announced_ = false;  // the first waiting vector's sync key
  RCRegion* playing_ = nullptr;
  int64_t start_ = 0;  // frame in which it begins
  int64_t end_ = 0;    // first frame after it
  std::vector<Element> elements_;
};

}  // namespace openr_host
