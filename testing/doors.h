// Changes that a test makes to messages on their way: hold them back, drop them.
#pragma once

#include <cstdint>
#include <deque>
#include <set>
#include <string>
#include <vector>

#include "runtime/core/schedule.h"
#include "testing/message_spec.h"
#include "testing/place.h"

namespace openr_host {
class System;
}

namespace openr::testing {

// Messages that are held back until the test releases them.  Released messages are the first at the
// instant at which the system runs next.
class HeldMessages {
 public:
  HeldMessages(openr_host::System* system, MessageSpec spec, const Place& place)
      : system_(system), spec_(std::move(spec)), place_(place) {}

  size_t count() const { return messages_.size(); }

  // Declares that it is no failure of the test if no message comes to be held.
  HeldMessages& Optional() { return is_optional_ = true, *this; }

  // Ends holding, and releases all messages, the oldest first.
  void Release();
  // Releases the oldest message, if there is one; goes on holding.
  void ReleaseOne();
  // Ends holding, and releases the messages in the order `order`, which has the index of each held
  // message once.  Throws std::invalid_argument otherwise.
  void ReleaseInOrder(const std::vector<size_t>& order);

  // Returns a text for people: "2 held: notify Blinker.Blink -> Eye.Light".
  std::string Text() const;

 private:
  friend class Doors;
  // Takes `message` if it is to be held.  Returns whether it is.
  bool Take(openr_host::Message* message);

  openr_host::System* const system_;
  const MessageSpec spec_;
  const Place place_;
  bool is_optional_ = false;
  bool has_held_ = false;
  bool is_open_ = false;
  std::deque<openr_host::Message*> messages_;
  std::set<uint64_t> passing_;  // numbers of the messages that were released one by one
};

// Messages that are dropped, so that their receivers do not get them.
class DroppedMessages {
 public:
  DroppedMessages(MessageSpec spec, int count, const Place& place)
      : spec_(std::move(spec)), place_(place), left_(count) {}

  int count() const { return static_cast<int>(texts_.size()); }

  // Declares that it is no failure of the test if fewer messages come than were to be dropped.
  DroppedMessages& Optional() { return is_optional_ = true, *this; }
  const std::vector<std::string>& texts() const { return texts_; }

 private:
  friend class Doors;
  const MessageSpec spec_;
  const Place place_;
  bool is_optional_ = false;
  int left_;
  std::vector<std::string> texts_;
};

class Doors : public openr_host::Gate {
 public:
  explicit Doors(openr_host::System* system) : system_(system) {}

  HeldMessages& Hold(MessageSpec spec, const Place& place) {
    return held_.emplace_back(system_, std::move(spec), place);
  }
  DroppedMessages& Drop(MessageSpec spec, int count, const Place& place) {
    return dropped_.emplace_back(std::move(spec), count, place);
  }

  // Reports, once, messages to be held or dropped that never came.
  void Verify(const ReportAt& report);

  bool Admit(openr_host::Message* message) override;

  // Returns a line for every door that is closed and holds messages.
  std::string Text() const;

 private:
  bool Lose(openr_host::Message* message);

  openr_host::System* const system_;
  std::deque<HeldMessages> held_;
  std::deque<DroppedMessages> dropped_;
};

}  // namespace openr::testing
