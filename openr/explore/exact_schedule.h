// The schedule of one run of a search that tries all orders of messages (search.cc).  It makes the
// first choices as the search says.  After them it avoids orders of messages that have the same
// result as an order of an earlier run.
//
// Swapping two deliveries that follow each other changes the result only in two cases: both
// deliveries use the same memory, or both send to the same object, whose queue keeps the order of
// sending.  A delivery uses the memory of the receiver, and of all objects whose regions (blocks of
// data) the receiver still has.  The delivery of a notification also uses the memory of the sender,
// because its region is read.
//
// After a delivery has been explored, it "sleeps" in later runs (sleep sets, Godefroid): the
// schedule does not choose it until another delivery has happened with which it cannot be swapped.
// When only sleeping deliveries are left, the run is cut, that is, stopped early, because it can
// only repeat orders of earlier runs.
#pragma once

#include <cstdint>
#include <map>
#include <nlohmann/json_fwd.hpp>
#include <vector>

#include "openr/explore/explore_schedule.h"

namespace openr_host {

// The objects that the delivery of a message concerns, one bit for each object.  `memory` has the
// objects whose memory the delivery uses, `queues` the objects to which the handler sends a
// message.  Objects with an id from 63 on share the last bit, because there are 64 bits.  Then more
// deliveries seem to concern the same object, so the search tries more orders than necessary, but
// misses none.
struct UsedObjects {
  uint64_t memory = 0;
  uint64_t queues = 0;

  bool Meets(const UsedObjects& other) const {
    return ((memory & other.memory) | (queues & other.queues)) != 0;
  }
};
constexpr UsedObjects kAllObjects = {~uint64_t{0}, ~uint64_t{0}};

// The deliveries that sleep, so the schedule does not choose them (sleep sets, at the top of this
// file).  The key is a receiver and stands for the delivery of the next message to it.  The value
// has the objects that this delivery concerns.  The delivery stops sleeping when another delivery
// concerns one of these objects too.
using SleepSet = std::map<ObjectId, UsedObjects>;

nlohmann::ordered_json UsedObjectsToJson(const UsedObjects& used);
UsedObjects UsedObjectsFromJson(const nlohmann::ordered_json& json);
nlohmann::ordered_json SleepToJson(const SleepSet& sleep);
SleepSet SleepFromJson(const nlohmann::ordered_json& json);

class ExactSchedule : public ExploreSchedule {
 public:
  // `plan` is a JSON object.  "choices" has, for the first choices of the run, the index of the
  // candidate to take.  A candidate is an object that can get its next message now.  "sleep" has
  // the SleepSet at the last of these choices.  At later choices the schedule takes the first
  // candidate whose delivery does not sleep.  If "reduce" is false, no delivery sleeps, so the
  // search also tries orders that repeat earlier ones.
  ExactSchedule(const System& system, const nlohmann::ordered_json& plan);

  // Records which objects the delivery of `message` concerns.  Cuts the run (stops it early) if no
  // other delivery was possible and this one sleeps (must not be chosen), because the run would
  // then repeat an order of an earlier run.  Called for every message before the handler of the
  // receiver runs.
  void OnDelivery(const Message& message);

  // Returns whether this run was cut, that is, stopped early.  A run is cut when every delivery
  // that could come next is asleep and so would only repeat an order of an earlier run.
  bool is_cut() const { return is_cut_; }

  // Returns the result of this run for the search: {"cut": is_cut(), "nodes": [...]}, with a node
  // {"candidates": [ids], "chosen": index, "touched": .., "sleep": ..} for every choice.  "touched"
  // has the objects that the chosen delivery concerned.  "sleep" has the SleepSet before the
  // choice.  For choices that the search made, "sleep" is empty, because the search already knows
  // the SleepSet.
  nlohmann::ordered_json Result();

 protected:
  size_t PickOf(const Deviation& spot, const std::vector<ObjectId>& candidates) override;
  int64_t PickDelayUs(const Deviation&, bool) override { return 0; }
  int64_t PickCostUs(const Deviation&, int64_t) override { return 0; }
  int64_t PickFrame(const Deviation&, int64_t) override { return 0; }
  void OnPost(const Message& message) override;

 private:
  static constexpr size_t kNone = SIZE_MAX;
  struct Node {
    std::vector<ObjectId> candidates;
    size_t chosen = 0;
    UsedObjects used;
    SleepSet sleep;
  };
  size_t FirstAwake(const std::vector<ObjectId>& candidates);
  void BeginDelivery(ObjectId target, size_t node);
  void FinishDelivery();
  void AddMemoryOf(ObjectId id);
  void AddHeld(const Object& object);

  const bool reduce_;
  std::vector<size_t> choices_;
  SleepSet next_sleep_;  // deliveries that must not be chosen at the last choice in choices_
  SleepSet sleep_;
  std::vector<Node> nodes_;
  bool is_cut_ = false;

  // ---- Members about the current delivery
  //
  // A delivery becomes current when its receiver is chosen.  If only one object had a message to
  // get, no choice was made, and the delivery becomes current when the message is delivered.
  // has_delivery_ is false while no delivery is current.
  bool has_delivery_ = false;
  bool is_begun_ = false;  // true when the message of the current delivery has been delivered
  ObjectId delivery_target_ = kNoObject;
  size_t delivery_node_ = kNone;
  UsedObjects used_;
};

}  // namespace openr_host
