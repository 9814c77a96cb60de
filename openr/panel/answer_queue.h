// AnswerQueue, a queue of the panel's server.  Threads put answers and events for a page into the
// queue, and the event loop sends them to the page.
#pragma once

#include <functional>
#include <mutex>
#include <string>
#include <utility>
#include <vector>

namespace openr_host {

// A queue of texts for a page.  The page and the threads that work for it share the queue.  All
// functions may be called in any thread.
class AnswerQueue {
 public:
  // Makes an empty queue of texts for a page.  The function `wake` makes the event loop look into
  // the queue.
  explicit AnswerQueue(std::function<void()> wake) : wake_(std::move(wake)) {}

  void Add(std::string text) {
    const std::lock_guard lock(mutex_);
    if (!wake_) return;
    texts_.push_back(std::move(text));
    wake_();
  }
  std::vector<std::string> TakeAll() {
    const std::lock_guard lock(mutex_);
    return std::exchange(texts_, {});
  }
  // Closes this queue of texts, because its page does not exist any more.  Drops all texts that
  // threads add later.
  void Close() {
    const std::lock_guard lock(mutex_);
    wake_ = nullptr;
    texts_.clear();
  }

 private:
  std::mutex mutex_;
  // A function that makes the event loop look into this queue of texts; null: the queue is closed.
  std::function<void()> wake_;
  std::vector<std::string> texts_;
};

}  // namespace openr_host
