// PageQueue, the messages that wait until the socket of one page takes them.
#pragma once

#include <deque>
#include <string>
#include <string_view>

namespace openr_host {

class PageQueue {
 public:
  // Bytes of messages that may wait.  A page beyond that is closed.
  static constexpr size_t kBytesMax = size_t{8} << 20;

  // Adds a message.  An event that shows a state ("pose", "values", "graph") replaces the one of
  // its name that still waits, because a page that is slow must get fewer of them and not later
  // ones.  When too much waits, these events are dropped first.  Returns false if too much waits
  // even so.
  bool Add(std::string text);

  // Removes the oldest message and returns it; "" if there is none.
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
