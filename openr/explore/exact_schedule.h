// The schedule of a search: a list of choices, and the choices that need not be tried.
//
// Two deliveries can be swapped without an effect unless they use the same memory, or send to the
// same object, whose queue keeps their order.  A delivery uses the memory of the receiver, of the
// sender of a notification, whose region is read, and of all objects whose regions the receiver
// still holds.  A delivery that has been explored sleeps: it need not be tried again until another
// one that it cannot be swapped with has happened (sleep sets, Godefroid).  A run in which only
// sleeping deliveries are left is cut, because its orders equal those of an earlier run.
#pragma once

#include <cstdint>
#include <map>
#include <nlohmann/json_fwd.hpp>
#include <vector>

#include "openr/explore/explore_schedule.h"

namespace openr_host {

// The objects that a delivery has to do with, one bit each.  Objects from 63 on share the last bit,
// which only makes more orders count as different.
struct Touched {
  uint64_t memory = 0;
  uint64_t queues = 0;

  bool Meets(const Touched& other) const {
    return ((memory & other.memory) | (queues & other.queues)) != 0;
  }
};
constexpr Touched kAllTouched = {~uint64_t{0}, ~uint64_t{0}};

// Deliveries that need not be tried, by receiver.  Each stands for the delivery of the receiver's
// next message.
using SleepSet = std::map<ObjectId, Touched>;

nlohmann::ordered_json TouchedToJson(const Touched& touched);
Touched TouchedFromJson(const nlohmann::ordered_json& json);
nlohmann::ordered_json SleepToJson(const SleepSet& sleep);
SleepSet SleepFromJson(const nlohmann::ordered_json& json);

class ExactSchedule : public ExploreSchedule {
 public:
  // `plan` has "choices" (indices of the candidates, for the first questions), "sleep" (the sleep
  // set at the last of these questions) and "reduce" (false: nothing sleeps).  Later questions get
  // the first candidate that does not sleep.
  ExactSchedule(const System& system, const nlohmann::ordered_json& plan);

  // Notes the delivery of `message`.  Called before its handler runs.
  void SawDelivery(const Message& message);

  // Returns whether this run was cut, because it can show nothing new.
  bool is_cut() const { return is_cut_; }

  // Returns {"cut": bool, "nodes": [{"candidates": [ids], "chosen": index, "touched": .., "sleep":
  // ..}]} with a node for every question.
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
  SleepSet next_sleep_;  // sleep set after the last of choices_
  SleepSet sleep_;
  std::vector<Node> nodes_;
  bool is_cut_ = false;

  // ---- The current delivery, from its choice or its beginning to the choice of the next delivery
  bool has_event_ = false;
  bool is_begun_ = false;  // its message has been delivered
  ObjectId event_target_ = kNoObject;
  size_t event_node_ = kNone;
  Touched touched_;
};

}  // namespace openr_host
