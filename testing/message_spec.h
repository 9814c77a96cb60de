// A description of messages, which all functions of a bench that concern messages take.
//
//   Notify("Blinker.Blink", "Eye.Light")                     data over that connection
//   Notify("Blinker.Blink").With(Data<int>(Gt(3)))           with a payload, to anybody
//   Ready("Eye.Light", "Blinker.Blink")                      AssertReady() of an observer
//   ToEntry("Blinker", "Alarm")                              an extra entry, DoStart, ...
//
// An end is an object ("Blinker"), a service ("Blinker.Blink", or its full name), or ""
// for any.
#pragma once

#include <gmock/gmock.h>

#include <cstring>
#include <optional>
#include <ostream>
#include <sstream>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include "testing/seen_message.h"

namespace openr::testing {

using PayloadMatcher = ::testing::Matcher<const SeenMessage&>;

class MessageSpec {
 public:
  explicit MessageSpec(std::optional<MessageKind> kind = {}) : kind_(kind) {}

  // Each returns a copy of this description with a further condition.
  MessageSpec From(std::string end) const;
  MessageSpec To(std::string end) const;
  MessageSpec ToEntry(std::string name) const;
  MessageSpec With(PayloadMatcher payload) const;

  // Return whether `message` fits, Matches() with and MatchesEnds() without the condition on the
  // payload.
  bool Matches(const SeenMessage& message) const;
  bool MatchesEnds(const SeenMessage& message) const;

  const std::optional<MessageKind>& kind() const { return kind_; }
  const std::string& from() const { return from_; }
  const std::string& to() const { return to_; }
  const std::string& entry() const { return entry_; }
  const std::optional<PayloadMatcher>& payload() const { return payload_; }

  // Returns "notify Blinker.Blink -> Eye.Light with a datum that is equal to 3".
  std::string Text() const;

 private:
  std::optional<MessageKind> kind_;
  std::string from_, to_;
  std::string entry_;
  std::optional<PayloadMatcher> payload_;
};

MessageSpec AnyMessage();
MessageSpec Notify(std::string subject = "", std::string observer = "");
MessageSpec Ready(std::string observer = "", std::string subject = "");
MessageSpec NotReady(std::string observer = "", std::string subject = "");
MessageSpec ToEntry(std::string object, std::string name);

// Returns whether `name` is the name `service` or its first parts: "Blinker.Blink" for
// "Blinker.Blink.int.S".
bool NamesService(std::string_view name, std::string_view service);

// ---- Payloads

// Reads all data of a message as values of type T.  Returns false, and writes the reason, when the
// size of a datum does not fit.
template <typename T>
bool ReadData(const SeenMessage& message, std::vector<T>* values, std::ostream* why) {
  static_assert(std::is_trivially_copyable_v<T>, "what objects send each other is plain data");
  for (int i = 0; i < message.data_count(); ++i) {
    const std::string_view bytes = message.data(i);
    if (bytes.size() != sizeof(T)) {
      *why << "whose datum " << i << " has " << bytes.size() << " bytes, where the type has "
           << sizeof(T);
      return false;
    }
    T& value = values->emplace_back();
    std::memcpy(&value, bytes.data(), sizeof value);
  }
  return true;
}

template <typename T>
class DatumMatcher : public ::testing::MatcherInterface<const SeenMessage&> {
 public:
  explicit DatumMatcher(::testing::Matcher<const T&> inner) : inner_(std::move(inner)) {}

  bool MatchAndExplain(const SeenMessage& message,
                       ::testing::MatchResultListener* listener) const override {
    std::vector<T> values;
    if (message.data_count() != 1) {
      *listener << "which has " << message.data_count() << " data";
      return false;
    }
    std::ostringstream why;
    if (!ReadData(message, &values, &why)) {
      *listener << why.str();
      return false;
    }
    *listener << "whose datum is " << ::testing::PrintToString(values[0]);
    ::testing::StringMatchResultListener inner;
    const bool matches = inner_.MatchAndExplain(values[0], &inner);
    if (!inner.str().empty()) *listener << ", " << inner.str();
    return matches;
  }
  void DescribeTo(std::ostream* out) const override {
    *out << "with a datum that ";
    inner_.DescribeTo(out);
  }
  void DescribeNegationTo(std::ostream* out) const override {
    *out << "without a datum that ";
    inner_.DescribeTo(out);
  }

 private:
  const ::testing::Matcher<const T&> inner_;
};

template <typename T>
class DataMatcher : public ::testing::MatcherInterface<const SeenMessage&> {
 public:
  explicit DataMatcher(::testing::Matcher<const std::vector<T>&> inner)
      : inner_(std::move(inner)) {}

  bool MatchAndExplain(const SeenMessage& message,
                       ::testing::MatchResultListener* listener) const override {
    std::vector<T> values;
    std::ostringstream why;
    if (!ReadData(message, &values, &why)) {
      *listener << why.str();
      return false;
    }
    *listener << "whose data are " << ::testing::PrintToString(values);
    return inner_.Matches(values);
  }
  void DescribeTo(std::ostream* out) const override {
    *out << "with data that ";
    inner_.DescribeTo(out);
  }
  void DescribeNegationTo(std::ostream* out) const override {
    *out << "without data that ";
    inner_.DescribeTo(out);
  }

 private:
  const ::testing::Matcher<const std::vector<T>&> inner_;
};

// Matches a message with one datum of type T that `matcher` (or a value) matches.
template <typename T, typename M>
PayloadMatcher Data(M matcher) {
  return ::testing::MakeMatcher(
      new DatumMatcher<T>(::testing::SafeMatcherCast<const T&>(std::move(matcher))));
}

// Matches a message with any number of data, as a vector of T.
template <typename T, typename M>
PayloadMatcher DataAre(M matcher) {
  return ::testing::MakeMatcher(
      new DataMatcher<T>(::testing::SafeMatcherCast<const std::vector<T>&>(std::move(matcher))));
}

// Matches a message with one datum, as a text up to its first NUL.
PayloadMatcher Text(::testing::Matcher<const std::string&> matcher);

}  // namespace openr::testing
