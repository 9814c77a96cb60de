// What shall happen, may happen, must not happen.
//
// Expected messages happen in the order in which they were asked for; what comes between
// them does not matter, unless the bench is strict: then every notification that is
// neither expected next nor allowed is a failure.
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
  // Reported once per call of this.
  void Disallow(MessageSpec spec, const Place& place);
  // Failures of strictness point to `place`.
  void set_strict(bool strict, const Place& place);

  // For every message, just before its handler runs.
  void See(const SeenMessage& message, const Report& report);

  // Whether everything expected has happened.
  bool met() const { return expected_.empty(); }

  // Reports what was expected and has not happened, and forgets it.
  void Verify(const Report& report);

 private:
  struct Expected {
    MessageSpec spec;
    Place place;
    std::string early;  // the last message that matched before its turn
    std::string other;  // the last one between the same ends with another payload, and why
  };
  struct Disallowed {
    MessageSpec spec;
    Place place;
    bool reported = false;
  };

  // Notes in what has not had its turn why `message` is not it.
  void Compare(const SeenMessage& message);
  void SeeUnexpected(const SeenMessage& message, const Report& report);

  std::deque<Expected> expected_;
  std::vector<MessageSpec> allowed_;
  std::deque<Disallowed> disallowed_;
  std::optional<Place> strict_;
};

}  // namespace openr::testing
