// PageQueue: keeps the messages that wait until the socket of one page takes them.
#pragma once

#include <deque>
#include <string>
#include <string_view>

namespace openr_host {

class PageQueue {
 public:
  // The largest number of bytes of messages for the page that may wait.  The server closes a page
  // for which more bytes wait.
  static constexpr size_t kBytesMax = size_t{8} << 20;

  // Adds a message for the page.  An event that shows a state ("pose", "values", "graph") replaces
  // the waiting event of the same name, so that a slow page skips old states instead of falling
  // behind.  If more than kBytesMax bytes wait, drops all events that show a state.  Returns false
  // if more than kBytesMax bytes wait even then.
  bool Add(std::string text);

  // Removes the oldest message and returns it; "" if no message waits.
  std::string Next();

  bool empty() const { return waiting_.empty(); }

 private:
  struct Message {
    std::string text;
    std::string_view state;  // name of the event that shows a state; "" for other messages
  };
  template <typename Condition>
  void Drop(Condition is_dropped);

  std::deque<Message> waiting_;
  size_t bytes_ = 0;
};

}  // namespace openr_host
