// Messages that a test expects, allows or disallows.
//
// Expected messages must come in the order in which the test has named them.  Other messages may
// come between them.  In a strict bench, each notification must be the next expected message or an
// allowed message; any other notification is a failure.
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
  // Reports, from now on, the first message that fits `spec` as a failure.
  void Disallow(MessageSpec spec, const Place& place);
  // Sets whether the bench is strict: then a notification that the test neither expects next nor
  // allows is a failure at the line `place`.
  void set_strict(bool strict, const Place& place);

  // Compares a message with the expectations.  Called for every message, just before its handler
  // runs.
  void Check(const SeenMessage& message, const Report& report);

  // Returns whether all expected messages have come.
  bool met() const { return expected_.empty(); }

  // Reports a failure for the expected messages that have not come, and forgets them.
  void Verify(const Report& report);

 private:
  struct Expected {
    MessageSpec spec;
    Place place;
    std::optional<SeenMessage> early;  // last message that fits `spec`, but came before its turn
    // The last message that fits `spec` in everything but its payload, and the reason why its
    // payload does not fit.  Both are for the text of a failure.
    std::optional<SeenMessage> other;
    std::string why_other;
  };
  struct Disallowed {
    MessageSpec spec;
    Place place;
    bool reported = false;
  };

  // Stores `message` in each expectation that it almost meets, for the text of a later failure: in
  // `early` if the message fits but came before its turn, in `other` if only the payload of the
  // message does not fit.
  void Compare(const SeenMessage& message);
  void CheckUnexpected(const SeenMessage& message, const Report& report);

  std::deque<Expected> expected_;
  std::vector<MessageSpec> allowed_;
  std::deque<Disallowed> disallowed_;
  std::optional<Place> strict_;
};

}  // namespace openr::testing
