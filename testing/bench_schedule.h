// BenchSchedule decides the order of messages on a bench where the robot leaves this order open,
// such as which of two objects gets a message first.  The seed decides, unless the test prefers an
// object.  A test can also delay or refuse messages.
#pragma once

#include <cstdint>
#include <deque>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "runtime/core/schedule.h"
#include "testing/message_spec.h"
#include "testing/place.h"

namespace openr::testing {

// A message that is refused as if the queue of its receiver were full: the n-th message that fits
// `spec`.
class RefusedMessage {
 public:
  RefusedMessage(MessageSpec spec, uint64_t nth, const Place& place)
      : spec_(std::move(spec)), nth_(nth), place_(place) {}

  // Lets the test pass even if the message never comes.
  RefusedMessage& Optional() { return is_optional_ = true, *this; }

  bool happened() const { return matches_ == nth_; }
  // Returns how many messages have fitted `spec` so far.  The count stops at the refused message.
  uint64_t matches() const { return matches_; }
  // Returns a description of the refused message; "" as long as no message was refused.
  const std::string& text() const { return text_; }

 private:
  friend class BenchSchedule;
  const MessageSpec spec_;
  const uint64_t nth_;
  const Place place_;
  bool is_optional_ = false;
  uint64_t matches_ = 0;
  std::string text_;
};

class BenchSchedule : public openr_host::Schedule {
 public:
  BenchSchedule(openr_host::System* system, uint64_t seed);

  // Sets the objects that go first where the robot leaves the order open (Schedule::Question).  The
  // first of `objects` goes before the second, and so on.  All other objects come after them, in
  // the order that the seed gives.
  void Prefer(std::vector<std::string> objects) { preferred_ = std::move(objects); }

  // From now on, delays each message that fits `spec` by `extra_us` microseconds.  0 ends the
  // delay.
  void Delay(MessageSpec spec, int64_t extra_us);

  RefusedMessage& Refuse(MessageSpec spec, uint64_t nth, const Place& place) {
    return refused_.emplace_back(std::move(spec), nth, place);
  }

  // Reports a failure for each message that the test wanted to refuse (Refuse()) and that was never
  // sent, because the test has then not tested the refusal.  Reports each message only once.
  void Verify(const ReportAt& report);

  size_t Choose(Question question, const std::vector<openr_host::ObjectId>& candidates) override;
  int64_t ExtraDelayUs(const openr_host::Message& message, int64_t now_us,
                       int64_t delay_us) override;
  bool Refuses(const openr_host::Message& message) override;

 private:
  openr_host::System* const system_;
  openr_host::SeedSchedule seed_schedule_;
  const bool is_canonical_;
  std::vector<std::string> preferred_;
  std::vector<std::pair<MessageSpec, int64_t>> delays_;
  // For each pair of a sender and a receiver: the time at which the last delayed message from the
  // sender to the receiver is due.  Later messages from this sender to this receiver become due at
  // this time or later, because they must not overtake the delayed message.
  std::map<std::pair<openr_host::ObjectId, openr_host::ObjectId>, int64_t> last_due_us_;
  std::deque<RefusedMessage> refused_;
};

}  // namespace openr::testing
