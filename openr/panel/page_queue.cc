#include "openr/panel/page_queue.h"

#include <utility>

namespace openr_host {
namespace {

// Returns the name of the event in the line `text` if the event shows a state of the run; "" for
// any other line.  A newer event of the same name replaces such an event.  Does not parse the line
// as JSON, but only compares its beginning, because a run writes the member "event" first.
std::string_view StateIn(std::string_view text) {
  constexpr std::string_view kBegin = "{\"event\":\"";
  if (!text.starts_with(kBegin)) return "";
  text.remove_prefix(kBegin.size());
  for (const std::string_view name : {"pose", "values", "graph"}) {
    if (text.starts_with(name) && text.substr(name.size()).starts_with('"')) return name;
  }
  return "";
}

}  // namespace

template <typename Condition>
void PageQueue::Drop(Condition is_dropped) {
  std::erase_if(waiting_, [&](const Message& message) {
    if (!is_dropped(message)) return false;
    bytes_ -= message.text.size();
    return true;
  });
}

bool PageQueue::Add(std::string text) {
  const std::string_view state = StateIn(text);
  if (!state.empty()) Drop([state](const Message& message) { return message.state == state; });
  bytes_ += text.size();
  waiting_.push_back({std::move(text), state});
  // Drops the events that show a state of the run first, because a newer state comes anyway;
  // answers and log lines come only once.
  if (bytes_ > kBytesMax) Drop([](const Message& message) { return !message.state.empty(); });
  return bytes_ <= kBytesMax;
}

std::string PageQueue::Next() {
  if (waiting_.empty()) return "";
  std::string text = std::move(waiting_.front().text);
  waiting_.pop_front();
  bytes_ -= text.size();
  return text;
}

}  // namespace openr_host
