// TestGate: a test uses it to hold back, drop or repeat messages between two objects.
#pragma once

#include <cstdint>
#include <deque>
#include <functional>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "runtime/core/schedule.h"
#include "testing/message_spec.h"
#include "testing/place.h"
#include "testing/seen_message.h"

namespace openr_host {
class System;
}

namespace openr::testing {

// Messages that are held back until the test releases them.  A released message is due at once, and
// is delivered before all other messages that are due at the same time with the same priority.
class HeldMessages {
 public:
  HeldMessages(openr_host::System* system, MessageSpec spec, const Place& place)
      : system_(system), spec_(std::move(spec)), place_(place) {}

  size_t count() const { return messages_.size(); }

  // Lets the test pass even if no message is ever held.
  HeldMessages& Optional() { return is_optional_ = true, *this; }

  // Releases all held messages, the oldest first, and holds no more messages.
  void Release();
  // Releases the oldest held message, if there is one.  Later messages are still held.
  void ReleaseOne();
  // Releases all held messages in the order `order`, and holds no more messages.  `order` has the
  // index of each held message exactly once; else std::invalid_argument is thrown.
  void ReleaseInOrder(const std::vector<size_t>& order);

  // Returns a description: "2 held: notify Blinker.Blink -> Eye.Light".
  std::string Text() const;

 private:
  friend class TestGate;
  // Moves `*message` into `messages_`, which holds it back, and returns true.  Returns false and
  // leaves the message alone if it does not match `spec_`, if Release() or ReleaseInOrder() was
  // called, or if ReleaseOne() has released this message.
  bool HoldBack(openr_host::OwnedMessage* message);

  openr_host::System* const system_;
  const MessageSpec spec_;
  const Place place_;
  bool is_optional_ = false;
  bool has_held_ = false;
  bool is_open_ = false;
  std::deque<openr_host::OwnedMessage> messages_;
  std::set<uint64_t> passing_;  // numbers of messages that ReleaseOne() has released
};

// Messages that are dropped on their way: their receivers never get them.
class DroppedMessages {
 public:
  DroppedMessages(MessageSpec spec, int count, const Place& place)
      : spec_(std::move(spec)), place_(place), left_(count) {}

  int count() const { return static_cast<int>(texts_.size()); }

  // Lets the test pass even if fewer messages are dropped than Drop() asked for.
  DroppedMessages& Optional() { return is_optional_ = true, *this; }
  const std::vector<std::string>& texts() const { return texts_; }

 private:
  friend class TestGate;
  const MessageSpec spec_;
  const Place place_;
  bool is_optional_ = false;
  int left_;
  std::vector<std::string> texts_;
};

// A message that its receiver gets twice: the n-th message that fits `spec`.
class RepeatedMessage {
 public:
  RepeatedMessage(MessageSpec spec, uint64_t nth, const Place& place)
      : spec_(std::move(spec)), nth_(nth), place_(place) {}

  // Lets the test pass even if the message never comes.
  RepeatedMessage& Optional() { return is_optional_ = true, *this; }

  bool happened() const { return matches_ == nth_; }
  // Returns a description of the message that the receiver gets twice; "" before its first
  // delivery.
  const std::string& text() const { return text_; }

 private:
  friend class TestGate;
  const MessageSpec spec_;
  const uint64_t nth_;
  const Place place_;
  bool is_optional_ = false;
  uint64_t matches_ = 0;  // number of messages so far that fit `spec_`; at most nth_
  std::string text_;
};

class TestGate : public openr_host::Gate {
 public:
  // A function that posts a message with the same sender, receiver and data once more.
  using PostAgain = std::function<void(const SeenMessage& message, const Place& place)>;

  TestGate(openr_host::System* system, PostAgain post_again)
      : system_(system), post_again_(std::move(post_again)) {}

  HeldMessages& Hold(MessageSpec spec, const Place& place) {
    return held_.emplace_back(system_, std::move(spec), place);
  }
  DroppedMessages& Drop(MessageSpec spec, int count, const Place& place) {
    return dropped_.emplace_back(std::move(spec), count, place);
  }

  RepeatedMessage& Repeat(MessageSpec spec, uint64_t nth, const Place& place) {
    return repeated_.emplace_back(std::move(spec), nth, place);
  }

  // Reports a failure for each Hold() that never held a message, for each Drop() that dropped fewer
  // messages than it was to drop, and for each Repeat() whose message never came.  Reports each of
  // them only once.
  void Verify(const ReportAt& report);

  openr_host::OwnedMessage Admit(openr_host::OwnedMessage message) override;
  void ForEach(const std::function<void(const openr_host::Message&)>& visit) const override;

  // Returns one line for each Hold() that holds messages now.
  std::string Text() const;

 private:
  // Drops `message` if a call of Drop() has asked for it: counts the message, and releases the
  // regions (shared memory) with the data of the message.  Returns whether the message was dropped.
  bool DropIfAsked(const openr_host::Message& message);

  // Posts a message with the same data again for each call of Repeat() that has asked to repeat
  // `message`.
  void RepeatIfAsked(const openr_host::Message& message);

  openr_host::System* const system_;
  const PostAgain post_again_;
  std::deque<HeldMessages> held_;
  std::deque<DroppedMessages> dropped_;
  std::deque<RepeatedMessage> repeated_;
};

}  // namespace openr::testing
