// Messages that a test expects, allows or disallows.
//
// Expected messages must come in the order of the calls.  Other messages may come between them,
// unless the bench is strict: then every notification that is neither expected next nor allowed is
// a failure.
#pragma once

#include <deque>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "testing/message_spec.h"
#include "testing/place.h"

namespace openr::testing {

class Expectations {
 public:
  using Report = ReportAt;

  void Expect(MessageSpec spec, const Place& place);
  void Allow(MessageSpec spec) { allowed_.push_back(std::move(spec)); }
  // From now on, reports the first message that fits `spec`.
  void Disallow(MessageSpec spec, const Place& place);
  // Sets strictness.  Failures because of it point to `place`.
  void set_strict(bool strict, const Place& place);

  // Compares a message with the expectations.  Called for every message, just before its handler
  // runs.
  void See(const SeenMessage& message, const Report& report);

  // Returns whether all expected messages have come.
  bool met() const { return expected_.empty(); }

  // Reports the expected messages that have not come, and forgets them.
  void Verify(const Report& report);

 private:
  struct Expected {
    MessageSpec spec;
    Place place;
    std::string early;  // last message that fitted, but came too early
    // The last message between the same ends with another payload, and the reason why it did not
    // fit.
    std::string other;
  };
  struct Disallowed {
    MessageSpec spec;
    Place place;
    bool reported = false;
  };

  // Notes, for each expectation that has not been met, the reason why `message` does not fit.
  void Compare(const SeenMessage& message);
  void SeeUnexpected(const SeenMessage& message, const Report& report);

  std::deque<Expected> expected_;
  std::vector<MessageSpec> allowed_;
  std::deque<Disallowed> disallowed_;
  std::optional<Place> strict_;
};

}  // namespace openr::testing
