// The order of messages on a bench: the order of the seed, until a test asks for another order.
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

// The n-th message of a kind, which is refused as if the receiver's queue was full.
class RefusedMessage {
 public:
  RefusedMessage(MessageSpec spec, uint64_t nth, const Place& place)
      : spec_(std::move(spec)), nth_(nth), place_(place) {}

  // Declares that it is no failure of the test if the message never comes.
  RefusedMessage& Optional() { return is_optional_ = true, *this; }

  bool happened() const { return matches_ == nth_; }
  uint64_t matches() const { return matches_; }  // messages of that kind so far, up to the n-th
  // Returns the message as text for people; "" before it came.
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

  // Sets the order in which objects come when several may be next: the earlier in `objects`, the
  // earlier.
  void Prefer(std::vector<std::string> objects) { preferred_ = std::move(objects); }

  // From now on, messages that fit `spec` take `extra_us` longer; 0: no longer.
  void Delay(MessageSpec spec, int64_t extra_us);

  RefusedMessage& Refuse(MessageSpec spec, uint64_t nth, const Place& place) {
    return refused_.emplace_back(std::move(spec), nth, place);
  }

  // Reports, once, the messages to be refused that never came.
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
  // The time at which the last delayed message is due, by sender and receiver.  A later message
  // does not overtake that message.
  std::map<std::pair<openr_host::ObjectId, openr_host::ObjectId>, int64_t> last_due_us_;
  std::deque<RefusedMessage> refused_;
};

}  // namespace openr::testing
