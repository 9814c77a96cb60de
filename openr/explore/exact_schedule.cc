#include "openr/explore/exact_schedule.h"

#include <algorithm>
#include <nlohmann/json.hpp>
#include <utility>

#include "runtime/core/api.h"
#include "runtime/core/observer_state.h"
#include "runtime/core/system.h"

namespace openr_host {
namespace {

using Json = nlohmann::ordered_json;

uint64_t BitOf(ObjectId id) { return uint64_t{1} << std::clamp(id, 0, 63); }

}  // namespace

Json UsedObjectsToJson(const UsedObjects& used) { return {used.memory, used.queues}; }

UsedObjects UsedObjectsFromJson(const Json& json) {
  return {json[0].get<uint64_t>(), json[1].get<uint64_t>()};
}

Json SleepToJson(const SleepSet& sleep) {
  Json json = Json::array();
  for (const auto& [object, used] : sleep) json.push_back({object, UsedObjectsToJson(used)});
  return json;
}

SleepSet SleepFromJson(const Json& json) {
  SleepSet sleep;
  for (const Json& entry : json) sleep[entry[0].get<ObjectId>()] = UsedObjectsFromJson(entry[1]);
  return sleep;
}

ExactSchedule::ExactSchedule(const System& system, const Json& plan)
    : ExploreSchedule(system),
      reduce_(plan.at("reduce").get<bool>()),
      choices_(plan.at("choices").get<std::vector<size_t>>()),
      next_sleep_(SleepFromJson(plan.at("sleep"))) {}

size_t ExactSchedule::PickOf(const Deviation& spot, const std::vector<ObjectId>& candidates) {
  FinishDelivery();
  const bool is_start = spot.kind == Deviation::Kind::kStart;
  if (is_start) sleep_.clear();
  Node node;
  node.candidates = candidates;
  const size_t index = nodes_.size();
  if (index < choices_.size()) {
    node.chosen = std::min(choices_[index], candidates.size() - 1);
    // At the last choice that the search has made for this run, replaces the deliveries that sleep
    // (must not be chosen) by next_sleep_, which the search has computed for this choice.
    if (index + 1 == choices_.size() && !is_start) sleep_ = std::move(next_sleep_);
  } else {
    node.sleep = sleep_;
    node.chosen = FirstAwake(candidates);
    if (node.chosen == kNone) {
      is_cut_ = true;
      return 0;
    }
  }
  const size_t chosen = node.chosen;
  nodes_.push_back(std::move(node));
  BeginDelivery(candidates[chosen], index);
  if (is_start) used_ = kAllObjects;
  return chosen;
}

size_t ExactSchedule::FirstAwake(const std::vector<ObjectId>& candidates) {
  for (size_t i = 0; i < candidates.size(); ++i) {
    if (!sleep_.contains(candidates[i])) return i;
  }
  return kNone;
}

void ExactSchedule::BeginDelivery(ObjectId target, size_t node) {
  has_delivery_ = true;
  is_begun_ = false;
  delivery_target_ = target;
  delivery_node_ = node;
  used_ = {BitOf(target), 0};
}

void ExactSchedule::OnDelivery(const Message& message) {
  // True if PickOf() has chosen the receiver of this message.  False if there was no choice,
  // because only this receiver could get a message.  The delivery to this receiver then becomes the
  // current delivery here.
  const bool was_chosen = has_delivery_ && !is_begun_ && delivery_target_ == message.target;
  if (!was_chosen) {
    FinishDelivery();
    if (sleep_.contains(message.target)) is_cut_ = true;
    BeginDelivery(message.target, kNone);
  }
  is_begun_ = true;
  if (message.kind == PayloadKind::kNotify) AddMemoryOf(message.sender);
  AddHeld(*system().object(message.target));
}

void ExactSchedule::FinishDelivery() {
  if (!std::exchange(has_delivery_, false)) return;
  if (delivery_node_ != kNone) nodes_[delivery_node_].used = used_;
  // Does not remove deliveries from sleep_ while the run repeats the choices that the search has
  // made, because PickOf() replaces the whole sleep_ at the last of these choices.
  if (nodes_.size() < choices_.size()) return;
  std::erase_if(sleep_,
                [this](const auto& sleeper) { return !reduce_ || sleeper.second.Meets(used_); });
}

void ExactSchedule::OnPost(const Message& message) { used_.queues |= BitOf(message.target); }

void ExactSchedule::AddMemoryOf(ObjectId id) {
  if (id != kNoObject) used_.memory |= BitOf(id);
}

void ExactSchedule::AddHeld(const Object& object) {
  for (const auto& observer : object.observers()) {
    for (const ObserverState::Held& held : observer->held) {
      if (!held.regions.empty()) AddMemoryOf(ObjectIdOf(held.subject.GetOID()));
    }
  }
}

Json ExactSchedule::Result() {
  FinishDelivery();
  Json nodes = Json::array();
  for (const Node& node : nodes_) {
    nodes.push_back({{"candidates", node.candidates},
                     {"chosen", node.chosen},
                     {"touched", UsedObjectsToJson(node.used)},
                     {"sleep", SleepToJson(node.sleep)}});
  }
  return {{"cut", is_cut_}, {"nodes", std::move(nodes)}};
}

}  // namespace openr_host
