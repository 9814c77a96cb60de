#include "testing/expectations.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

namespace openr::testing {

void Expectations::Expect(MessageSpec spec, const Place& place) {
  expected_.push_back({std::move(spec), place, {}, {}, ""});
}

void Expectations::Disallow(MessageSpec spec, const Place& place) {
  disallowed_.push_back({std::move(spec), place});
}

void Expectations::set_strict(bool strict, const Place& place) {
  strict_ = strict ? std::optional(place) : std::nullopt;
}

void Expectations::Check(const SeenMessage& message, const Report& report) {
  for (Disallowed& disallowed : disallowed_) {
    if (disallowed.reported || !disallowed.spec.Matches(message)) continue;
    disallowed.reported = true;
    report(disallowed.place, fmt::format("Disallowed, but it happened: {}\n  {}",
                                         disallowed.spec.Text(), message.Text()));
  }
  if (!expected_.empty() && expected_.front().spec.Matches(message)) {
    expected_.pop_front();
    return;
  }
  Compare(message);
  if (strict_ && message.kind() == MessageKind::kNotify) CheckUnexpected(message, report);
}

void Expectations::Compare(const SeenMessage& message) {
  for (Expected& expected : expected_) {
    if (!expected.spec.MatchesEnds(message)) continue;
    if (expected.spec.Matches(message)) {
      expected.early = message.Past();
      continue;
    }
    ::testing::StringMatchResultListener why;
    expected.spec.payload()->MatchAndExplain(message, &why);
    expected.other = message.Past();
    expected.why_other = why.str();
  }
}

void Expectations::CheckUnexpected(const SeenMessage& message, const Report& report) {
  if (std::any_of(allowed_.begin(), allowed_.end(),
                  [&](const MessageSpec& spec) { return spec.Matches(message); })) {
    return;
  }
  report(*strict_,
         fmt::format("Not expected, and the bench is strict:\n  {}\n{}", message.Text(),
                     expected_.empty() ? "Nothing more was expected."
                                       : "Expected next: " + expected_.front().spec.Text()));
}

void Expectations::Verify(const Report& report) {
  if (expected_.empty()) return;
  const std::deque<Expected> missing = std::exchange(expected_, {});
  const Expected& first = missing.front();
  std::string text = fmt::format("Expected, but it did not happen: {}", first.spec.Text());
  if (first.other) text += "\n  this did, with another payload: " + first.other->Text();
  if (!first.why_other.empty()) text += "\n    " + first.why_other;
  if (first.early) text += "\n  this did, before its turn: " + first.early->Text();
  for (size_t i = 1; i < missing.size(); ++i) text += "\nand after it: " + missing[i].spec.Text();
  report(first.place, text);
}

}  // namespace openr::testing
