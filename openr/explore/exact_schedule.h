// The schedule of one run of an exhaustive search.  It makes the choices that the search gives it,
// and then avoids orders of messages that equal an order explored before.
//
// The deliveries of two messages can be swapped without an effect unless both use the same memory,
// or both send to the same object, whose queue keeps the order of sending.  A delivery uses the
// memory of the receiver, of the sender of a notification, whose region is read, and of all objects
// whose regions the receiver still has.
//
// After a delivery has been explored, it "sleeps" in later runs (sleep sets, Godefroid): it is not
// chosen until another delivery has happened with which it cannot be swapped.  A run in which only
// sleeping deliveries are left is cut, that is, stopped early, because it can only repeat orders of
// earlier runs.
#pragma once

#include <cstdint>
#include <map>
#include <nlohmann/json_fwd.hpp>
#include <vector>

#include "openr/explore/explore_schedule.h"

namespace openr_host {

// The objects that the delivery of a message concerns, one bit for each object: `memory` for
// objects whose memory is used, `queues` for objects to which the handler sends a message.  Objects
// with an id from 63 on share the last bit, because there are 64 bits.  Then more deliveries seem
// to concern the same object, and the search tries more orders than necessary, but misses none.
struct Touched {
  uint64_t memory = 0;
  uint64_t queues = 0;

  bool Meets(const Touched& other) const {
    return ((memory & other.memory) | (queues & other.queues)) != 0;
  }
};
constexpr Touched kAllTouched = {~uint64_t{0}, ~uint64_t{0}};

// The deliveries that sleep, which means that they need not be tried (see above).  The key is a
// receiver and stands for the delivery of the next message to this receiver.  The value has the
// objects that this delivery concerns; they decide when the delivery stops sleeping.
using SleepSet = std::map<ObjectId, Touched>;

nlohmann::ordered_json TouchedToJson(const Touched& touched);
Touched TouchedFromJson(const nlohmann::ordered_json& json);
nlohmann::ordered_json SleepToJson(const SleepSet& sleep);
SleepSet SleepFromJson(const nlohmann::ordered_json& json);

class ExactSchedule : public ExploreSchedule {
 public:
  // `plan` is a JSON object.  "choices" has the indices of the candidates to take at the first
  // choices of the run.  "sleep" has the SleepSet at the last of these choices.  At later choices
  // the schedule takes the first candidate whose delivery does not sleep.  If "reduce" is false, no
  // delivery sleeps, so the search also tries orders that are equal to earlier ones.
  ExactSchedule(const System& system, const nlohmann::ordered_json& plan);

  // Begins the delivery of `message`: notes which objects it concerns, and cuts the run if this
  // delivery sleeps.  Called before the handler of the receiver runs.
  void SawDelivery(const Message& message);

  // Returns whether this run was cut, that is, stopped early, because only sleeping deliveries were
  // left.
  bool is_cut() const { return is_cut_; }

  // Returns the result of this run for the search: {"cut": bool, "nodes": [{"candidates": [ids],
  // "chosen": index, "touched": .., "sleep": ..}]}, with a node for every choice.  "touched" has
  // the objects that the chosen delivery concerned, "sleep" the SleepSet before the choice; it is
  // empty for the choices that the plan gave.
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
  SleepSet next_sleep_;  // sleep set to use at the last of choices_
  SleepSet sleep_;
  std::vector<Node> nodes_;
  bool is_cut_ = false;

  // ---- The current delivery.  A delivery becomes the current one when it is chosen.  If there was
  // no choice, because there was only one candidate, it becomes the current one when its message is
  // delivered.
  bool has_event_ = false;
  bool is_begun_ = false;  // the message of this delivery has been delivered
  ObjectId event_target_ = kNoObject;
  size_t event_node_ = kNone;
  Touched touched_;
};

}  // namespace openr_host
