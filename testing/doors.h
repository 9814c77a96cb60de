// What a test does to messages on their way: hold them, lose them.
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

// Messages that wait at a door until the test lets them go on.  They go first at the
// instant at which the system runs next.
class HeldMessages {
 public:
  HeldMessages(openr_host::System* system, MessageSpec spec, const Place& place)
      : system_(system), spec_(std::move(spec)), place_(place) {}

  size_t count() const { return messages_.size(); }

  // That nobody ever comes to the door is no failure of the test.
  HeldMessages& Optional() { return is_optional_ = true, *this; }

  // Opens the door for good and lets all go, the oldest first.
  void Release();
  // The oldest one, if any; the door stays closed for the others.
  void ReleaseOne();
  // Opens the door for good; `order` are indices into what is held, each once.
  // REQUIRES: order.size() == count().
  void ReleaseInOrder(const std::vector<size_t>& order);

  // "2 held: notify Blinker.Blink -> Eye.Light", for people.
  std::string Text() const;

 private:
  friend class Doors;
  // True: it is kept here.
  bool Take(openr_host::Message* message);

  openr_host::System* const system_;
  const MessageSpec spec_;
  const Place place_;
  bool is_optional_ = false;
  bool has_held_ = false;
  bool is_open_ = false;
  std::deque<openr_host::Message*> messages_;
  std::set<uint64_t> passing_;  // numbers of those that were released one by one
};

// Messages that get lost on their way: their receiver never hears of them.
class DroppedMessages {
 public:
  DroppedMessages(MessageSpec spec, int count, const Place& place)
      : spec_(std::move(spec)), place_(place), left_(count) {}

  int count() const { return static_cast<int>(texts_.size()); }

  // That fewer than asked for come along is no failure of the test.
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

  // Reports what was to be held or lost and never came, once.
  void Verify(const ReportAt& report);

  bool Admit(openr_host::Message* message) override;

  // A line for every closed door with somebody behind it.
  std::string Text() const;

 private:
  bool Lose(openr_host::Message* message);

  openr_host::System* const system_;
  std::deque<HeldMessages> held_;
  std::deque<DroppedMessages> dropped_;
};

}  // namespace openr::testing
