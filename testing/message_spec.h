// MessageSpec, a description of messages.  All functions of a bench that concern messages take a
// MessageSpec.
//
//   Notify("Blinker.Blink", "Eye.Light")            data that Blinker sends to Eye
//   Notify("Blinker.Blink").With(Data<int>(Gt(3)))  data above 3 that Blinker sends to anybody
//   Ready("Eye.Light", "Blinker.Blink")             AssertReady() of the observer Eye.Light
//   ToEntry("Blinker", "Alarm")                     a message for the handler Alarm of Blinker
//
// A sender or receiver is named by its object ("Blinker") or by its service ("Blinker.Blink", or
// the full name).  An empty name fits every sender or receiver.
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

  // From(), To(), ToEntry() and With() return a copy of this description with one more condition:
  // on the sender, on the receiver, on the name of the receiver's handler, or on the payload.
  MessageSpec From(std::string end) const;
  MessageSpec To(std::string end) const;
  MessageSpec ToEntry(std::string name) const;
  MessageSpec With(PayloadMatcher payload) const;

  // Returns whether `message` meets all conditions.
  bool Matches(const SeenMessage& message) const;
  // Returns whether `message` meets all conditions except the condition on the payload, which is
  // not checked.
  bool MatchesEnds(const SeenMessage& message) const;

  const std::optional<MessageKind>& kind() const { return kind_; }
  const std::string& from() const { return from_; }
  const std::string& to() const { return to_; }
  const std::string& entry() const { return entry_; }
  const std::optional<PayloadMatcher>& payload() const { return payload_; }

  // Returns a description such as "notify Blinker.Blink -> Eye.Light with a datum that is equal to
  // 3".
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

// ---- Payloads

// Appends all data of a message to `values`, each as a T.  If a datum does not have the size of a
// T, writes a message about this to `why` and returns false.
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

// Matches a message with exactly one datum, a T that `matcher` accepts.  If `matcher` is a plain
// value, the datum must be equal to this value.
template <typename T, typename M>
PayloadMatcher Data(M matcher) {
  return ::testing::MakeMatcher(
      new DatumMatcher<T>(::testing::SafeMatcherCast<const T&>(std::move(matcher))));
}

// Matches a message if `matcher` accepts its data, given as a std::vector<T>.
template <typename T, typename M>
PayloadMatcher DataAre(M matcher) {
  return ::testing::MakeMatcher(
      new DataMatcher<T>(::testing::SafeMatcherCast<const std::vector<T>&>(std::move(matcher))));
}

// Matches a message with exactly one datum, if `matcher` accepts it as a text up to its first NUL.
PayloadMatcher Text(::testing::Matcher<const std::string&> matcher);

}  // namespace openr::testing
