// The order of a bench: the seed's, until a test asks for another.
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

// The n-th message of a kind that finds its receiver's queue full.
class RefusedMessage {
 public:
  RefusedMessage(MessageSpec spec, uint64_t nth, const Place& place)
      : spec_(std::move(spec)), nth_(nth), place_(place) {}

  // That it never comes is no failure of the test.
  RefusedMessage& Optional() { return is_optional_ = true, *this; }

  bool happened() const { return matches_ == nth_; }
  uint64_t matches() const { return matches_; }  // messages of that kind so far, up to the n-th
  // The message, for people; "" before it happened.
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

  // Of objects that may be next, these come first, in this order.
  void Prefer(std::vector<std::string> objects) { preferred_ = std::move(objects); }

  // Messages take `extra_us` longer from now on; 0: as before.
  void Delay(MessageSpec spec, int64_t extra_us);

  RefusedMessage& Refuse(MessageSpec spec, uint64_t nth, const Place& place) {
    return refused_.emplace_back(std::move(spec), nth, place);
  }

  // Reports what was to be refused and never came, once.
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
  // When the last delayed message from a sender to a receiver is due: none overtakes it.
  std::map<std::pair<openr_host::ObjectId, openr_host::ObjectId>, int64_t> last_due_us_;
  std::deque<RefusedMessage> refused_;
};

}  // namespace openr::testing
