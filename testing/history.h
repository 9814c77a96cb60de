// History, the last delivered messages.  Failures of tests print these messages.
#pragma once

#include <deque>
#include <string>

#include "testing/seen_message.h"

namespace openr::testing {

class History {
 public:
  static constexpr size_t kKept = 12;

  void Add(const SeenMessage& message) {
    if (messages_.size() == kKept) messages_.pop_front();
    messages_.push_back(message.Past());
  }

  // Returns one line per message, the oldest first.
  std::string Text() const {
    std::string text;
    for (const SeenMessage& message : messages_) text += "  " + message.Text() + "\n";
    return text;
  }

  // Returns the number of the last message; 0 if there was no message.
  uint64_t last_number() const { return messages_.empty() ? 0 : messages_.back().number(); }

 private:
  std::deque<SeenMessage> messages_;
};

}  // namespace openr::testing
