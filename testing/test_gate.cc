#include "testing/test_gate.h"

#include <OPENR/ObjcommMessages.h>
#include <OPENR/RCRegion.h>
#include <fmt/format.h>

#include <stdexcept>
#include <utility>

#include "runtime/core/system.h"

namespace openr::testing {

using openr_host::CurrentScope;
using openr_host::Message;
using openr_host::OwnedMessage;
using openr_host::PayloadKind;
using openr_host::System;

namespace {

// Releases the shared memory (regions) with the data of a dropped message, because the receiver
// will not do it.
void ReturnRegions(System* system, const Message& message) {
  if (message.kind == PayloadKind::kNotify) {
    const CurrentScope scope(system, system->object(message.sender));
    const auto& notify = *reinterpret_cast<const ONotifyMessage*>(message.payload);
    for (int i = 0; i < notify.numOfData; ++i) notify.data[i].srcRCR->RemoveReference();
  } else if (message.kind == PayloadKind::kReady) {
    const CurrentScope scope(system, system->object(message.target));
    const auto& ready = *reinterpret_cast<const OReadyMessage*>(message.payload);
    for (int i = 0; i < ready.numOfData; ++i) ready.rcRegion[i]->RemoveReference();
  }
}

}  // namespace

bool HeldMessages::HoldBack(OwnedMessage* message) {
  if (is_open_ || passing_.erase((*message)->number) > 0) return false;
  if (!spec_.Matches(SeenMessage(*system_, **message))) return false;
  has_held_ = true;
  messages_.push_back(std::move(*message));
  return true;
}

// Puts the held messages back at the head of the queue, the newest message first.  So the oldest
// message is at the head in the end, and the messages keep their order.
void HeldMessages::Release() {
  is_open_ = true;
  for (; !messages_.empty(); messages_.pop_back()) system_->Readmit(std::move(messages_.back()));
}

void HeldMessages::ReleaseOne() {
  if (messages_.empty()) return;
  passing_.insert(messages_.front()->number);
  system_->Readmit(std::move(messages_.front()));
  messages_.pop_front();
}

void HeldMessages::ReleaseInOrder(const std::vector<size_t>& order) {
  if (std::set<size_t>(order.begin(), order.end()).size() != messages_.size() ||
      order.size() != messages_.size()) {
    throw std::invalid_argument(fmt::format(
        "ReleaseInOrder: {} messages are held; the order must name each once", messages_.size()));
  }
  std::deque<OwnedMessage> sorted;
  for (const size_t index : order) sorted.push_back(std::move(messages_.at(index)));
  messages_ = std::move(sorted);
  Release();
}

std::string HeldMessages::Text() const {
  return fmt::format("{} held: {}", messages_.size(), spec_.Text());
}

OwnedMessage TestGate::Admit(OwnedMessage message) {
  if (DropIfAsked(*message)) return nullptr;
  for (HeldMessages& held : held_) {
    if (held.HoldBack(&message)) return nullptr;
  }
  RepeatIfAsked(*message);
  return message;
}

void TestGate::ForEach(const std::function<void(const Message&)>& visit) const {
  for (const HeldMessages& held : held_) {
    for (const OwnedMessage& message : held.messages_) visit(*message);
  }
}

void TestGate::RepeatIfAsked(const Message& message) {
  for (RepeatedMessage& repeated : repeated_) {
    if (repeated.happened()) continue;
    const SeenMessage seen(*system_, message);
    if (!repeated.spec_.Matches(seen)) continue;
    repeated.matches_ += 1;
    if (!repeated.happened()) continue;
    repeated.text_ = seen.Text();
    post_again_(seen, repeated.place_);
  }
}

bool TestGate::DropIfAsked(const Message& message) {
  for (DroppedMessages& dropped : dropped_) {
    if (dropped.left_ == 0) continue;
    const SeenMessage seen(*system_, message);
    if (!dropped.spec_.Matches(seen)) continue;
    --dropped.left_;
    dropped.texts_.push_back(seen.Text());
    openr_host::Object* const target = system_->object(message.target);
    if (!message.is_reply) target->NoteTaken();
    target->statistics().NoteDropped();
    ReturnRegions(system_, message);
    return true;
  }
  return false;
}

void TestGate::Verify(const ReportAt& report) {
  for (HeldMessages& held : held_) {
    if (held.has_held_ || std::exchange(held.is_optional_, true)) continue;
    report(held.place_,
           fmt::format("Hold: nothing ever came: {}; .Optional() allows that", held.spec_.Text()));
  }
  for (DroppedMessages& dropped : dropped_) {
    if (dropped.left_ == 0 || std::exchange(dropped.is_optional_, true)) continue;
    report(dropped.place_,
           fmt::format("Drop: {} of {} came: {}; .Optional() allows that", dropped.count(),
                       dropped.count() + dropped.left_, dropped.spec_.Text()));
  }
  for (RepeatedMessage& repeated : repeated_) {
    if (repeated.happened() || std::exchange(repeated.is_optional_, true)) continue;
    report(repeated.place_, fmt::format("Repeat: {} of {} came: {}; .Optional() allows that",
                                        repeated.matches_, repeated.nth_, repeated.spec_.Text()));
  }
}

std::string TestGate::Text() const {
  std::string text;
  for (const HeldMessages& held : held_) {
    if (held.count() > 0) text += "  " + held.Text() + "\n";
  }
  return text;
}

}  // namespace openr::testing
