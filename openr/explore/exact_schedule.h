// The schedule of a search: choices one after the other, and what is known to be in vain.
//
// Two deliveries can be swapped without anybody noticing unless they have to do with the same
// memory, or send to the same object, so that the order in its queue is at stake.  Memory is that
// of the receiver, of the sender of a notification, whose region is read, and of all whose regions
// the receiver still holds.  What has been explored sleeps until something that it cannot be
// swapped with wakes it (Godefroid's sleep sets); a run in which only sleepers are left is cut: its
// orders are those of another one.
#pragma once

#include <cstdint>
#include <map>
#include <nlohmann/json_fwd.hpp>
#include <vector>

#include "openr/explore/explore_schedule.h"

namespace openr_host {

// What a delivery has to do with: one bit an object; objects from 63 on share the last one, which
// only costs reduction.
struct Touched {
  uint64_t memory = 0;
  uint64_t queues = 0;

  bool Meets(const Touched& other) const {
    return ((memory & other.memory) | (queues & other.queues)) != 0;
  }
};
constexpr Touched kAllTouched = {~uint64_t{0}, ~uint64_t{0}};

// Deliveries that need not be tried, by receiver: its next message.
using SleepSet = std::map<ObjectId, Touched>;

nlohmann::ordered_json TouchedToJson(const Touched& touched);
Touched TouchedFromJson(const nlohmann::ordered_json& json);
nlohmann::ordered_json SleepToJson(const SleepSet& sleep);
SleepSet SleepFromJson(const nlohmann::ordered_json& json);

class ExactSchedule : public ExploreSchedule {
 public:
  // `plan`: "choices" (indices, for the first questions), "sleep" (for the last of them), "reduce"
  // (false: nothing sleeps).  Later questions get the first candidate that is awake.
  ExactSchedule(const System& system, const nlohmann::ordered_json& plan);

  // Before its handler runs.
  void SawDelivery(const Message& message);

  // Nothing new can come of this run.
  bool is_cut() const { return is_cut_; }

  // {"cut": bool, "nodes": [{"candidates": [ids], "chosen": index, "touched": .., "sleep": ..}]},
  // a node for every question.
  nlohmann::ordered_json Tell();

 protected:
  size_t PickOf(const Deviation& spot, const std::vector<ObjectId>& candidates) override;
  int64_t PickDelayUs(const Deviation&, bool) override { return 0; }
  int64_t PickCostUs(const Deviation&, int64_t) override { return 0; }
  int64_t PickFrame(const Deviation&, int64_t) override { return 0; }
  void SawPost(const Message& message) override;

 private:
  static constexpr size_t kNone = SIZE_MAX;
  struct Node {
    std::vector<ObjectId> candidates;
    size_t chosen = 0;
    Touched touched;
    SleepSet sleep;
  };
  size_t FirstAwake(const std::vector<ObjectId>& candidates);
  void BeginEvent(ObjectId target, size_t node);
  void FinishEvent();
  void TouchMemoryOf(ObjectId id);
  void TouchHeld(const Object& object);

  const bool reduce_;
  std::vector<size_t> choices_;
  SleepSet next_sleep_;  // from the last of choices_ on
  SleepSet sleep_;
  std::vector<Node> nodes_;
  bool is_cut_ = false;

  // The delivery that goes on: from its choice or its beginning to that of the next one.
  bool has_event_ = false;
  bool is_begun_ = false;  // its message has been delivered
  ObjectId event_target_ = kNoObject;
  size_t event_node_ = kNone;
  Touched touched_;
};

}  // namespace openr_host
