#include "testing/message_spec.h"

#include "runtime/core/post_as_object.h"

namespace openr::testing {
namespace {

bool NamesEnd(const std::string& name, const SeenMessage::End& end) {
  if (name.empty()) return true;
  return name.find('.') == std::string::npos ? name == end.object
                                             : openr_host::NamesService(name, end.service);
}

const char* WordFor(const std::optional<MessageKind>& kind) {
  const char* const word = kind ? WordFor(*kind) : nullptr;
  return word == nullptr ? "message" : word;
}

class TextMatcher : public ::testing::MatcherInterface<const SeenMessage&> {
 public:
  explicit TextMatcher(::testing::Matcher<const std::string&> inner) : inner_(std::move(inner)) {}

  bool MatchAndExplain(const SeenMessage& message,
                       ::testing::MatchResultListener* listener) const override {
    if (message.data_count() != 1) {
      *listener << "which has " << message.data_count() << " data";
      return false;
    }
    const std::string_view bytes = message.data(0);
    const std::string text(bytes.substr(0, bytes.find('\0')));
    *listener << "whose text is " << ::testing::PrintToString(text);
    return inner_.Matches(text);
  }
  void DescribeTo(std::ostream* out) const override {
    *out << "with a text that ";
    inner_.DescribeTo(out);
  }
  void DescribeNegationTo(std::ostream* out) const override {
    *out << "without a text that ";
    inner_.DescribeTo(out);
  }

 private:
  const ::testing::Matcher<const std::string&> inner_;
};

}  // namespace

MessageSpec MessageSpec::From(std::string end) const {
  MessageSpec spec = *this;
  spec.from_ = std::move(end);
  return spec;
}

MessageSpec MessageSpec::To(std::string end) const {
  MessageSpec spec = *this;
  spec.to_ = std::move(end);
  return spec;
}

MessageSpec MessageSpec::ToEntry(std::string name) const {
  MessageSpec spec = *this;
  spec.entry_ = std::move(name);
  return spec;
}

MessageSpec MessageSpec::With(PayloadMatcher payload) const {
  MessageSpec spec = *this;
  spec.payload_ = std::move(payload);
  return spec;
}

bool MessageSpec::MatchesEnds(const SeenMessage& message) const {
  if (kind_ && *kind_ != message.kind()) return false;
  if (!NamesEnd(to_, message.to()) || !NamesEnd(from_, message.from())) return false;
  return entry_.empty() || entry_ == message.entry();
}

bool MessageSpec::Matches(const SeenMessage& message) const {
  return MatchesEnds(message) && (!payload_ || payload_->Matches(message));
}

std::string MessageSpec::Text() const {
  std::ostringstream text;
  text << (entry_.empty() ? WordFor(kind_) : entry_);
  if (!from_.empty() || !to_.empty()) {
    text << " " << (from_.empty() ? "(any)" : from_) << " -> " << (to_.empty() ? "(any)" : to_);
  }
  if (payload_) {
    text << " ";
    payload_->DescribeTo(&text);
  }
  return text.str();
}

MessageSpec AnyMessage() { return MessageSpec(); }

MessageSpec Notify(std::string subject, std::string observer) {
  return MessageSpec(MessageKind::kNotify).From(std::move(subject)).To(std::move(observer));
}

MessageSpec Ready(std::string observer, std::string subject) {
  return MessageSpec(MessageKind::kReady).From(std::move(observer)).To(std::move(subject));
}

MessageSpec NotReady(std::string observer, std::string subject) {
  return MessageSpec(MessageKind::kNotReady).From(std::move(observer)).To(std::move(subject));
}

MessageSpec ToEntry(std::string object, std::string name) {
  return MessageSpec(MessageKind::kOther).To(std::move(object)).ToEntry(std::move(name));
}

PayloadMatcher Text(::testing::Matcher<const std::string&> matcher) {
  return ::testing::MakeMatcher(new TextMatcher(std::move(matcher)));
}

}  // namespace openr::testing
