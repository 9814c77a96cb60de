#include "runtime/core/message_queue.h"

#include <algorithm>
#include <new>
#include <tuple>
#include <utility>

#include "runtime/base/assert.h"
#include "runtime/core/schedule.h"

namespace openr_host {
namespace {

constexpr size_t kChunk = 64;  // number of messages that are allocated at a time

}  // namespace

bool MessageQueue::LaterMessage::operator<(const LaterMessage& other) const {
  return std::tie(due_us, level, number) > std::tie(other.due_us, other.level, other.number);
}

MessageQueue::MessageQueue() : levels_(kLevels) {}

MessageQueue::~MessageQueue() {
  const size_t count = kChunk * chunks_.size();
  size_t here = size();
  for (const Message* message = free_.first(); message != nullptr; message = message->next) ++here;
  ASSERT(here == count, "{} of {} messages outlive their pool", count - here, count);
}

void MessageQueue::AddChunk() {
  chunks_.emplace_back(new Message[kChunk]);
  // Puts the last message of a new chunk (array of messages) into the pool first, because the pool
  // hands out first the message that it got last.  So messages are handed out in the order of their
  // addresses.
  for (size_t i = kChunk; i > 0; --i) {
    Message& message = chunks_.back()[i - 1];
    message.pool = &free_;
    free_.Add(&message);
  }
}

// Adds `message`, which is not due yet, to later_, a heap with the first message to come due at the
// top.
void MessageQueue::InsertLater(Message* message, uint32_t level) {
  ASSERT(message->due_us > now_us_, "message {} is due at {} us, now is {} us", message->number,
         message->due_us, now_us_);
  later_.push_back({message->due_us, level, message->number, message});
  std::push_heap(later_.begin(), later_.end());
}

void MessageQueue::PushFront(OwnedMessage message, int priority) {
  ASSERT(message->due_us == now_us_, "message {} is due at {} us, now is {} us", message->number,
         message->due_us, now_us_);
  const uint32_t level = LevelOf(*message, priority);
  List& list = levels_[level];
  message->next = list.head;
  list.head = message.release();
  if (list.head->next == nullptr) list.tail = list.head;
  Mark(level);
}

// Searches marks_ from `level` on, and returns the first level whose bit is 1; kLevels if there is
// none.  A level is a number for the class and priority of messages.  Its bit is 1 if its list may
// have messages.
uint32_t MessageQueue::NextMarked(uint32_t level) const {
  uint64_t before = (uint64_t{1} << (level % 64)) - 1;  // bits of the message levels before `level`
  for (uint32_t word = level / 64; word < kLevels / 64; ++word) {
    const uint64_t bits = marks_[word] & ~std::exchange(before, 0);
    if (bits != 0) return word * 64 + static_cast<uint32_t>(__builtin_ctzll(bits));
  }
  return kLevels;
}

// Called when all messages of the level first_level_ (a class and priority of messages) were taken.
// Clears the bit of this level in marks_, and sets first_level_ to the next level with a bit that
// is 1.
void MessageQueue::LeaveFirstLevel() {
  marks_[first_level_ / 64] &= ~(uint64_t{1} << (first_level_ % 64));
  first_level_ = NextMarked(first_level_);
}

const Message* MessageQueue::First() const {
  for (uint32_t level = first_level_; level < kLevels; level = NextMarked(level + 1)) {
    if (levels_[level].head != nullptr) return levels_[level].head;
  }
  return nullptr;
}

size_t MessageQueue::size() const {
  size_t count = later_.size();
  for (uint32_t level = first_level_; level < kLevels; ++level) {
    for (const Message* m = levels_[level].head; m != nullptr; m = m->next) ++count;
  }
  return count;
}

// Lets `schedule` choose among the receivers of the messages in `list`.  REQUIRES: `list` is not
// empty.
ObjectId MessageQueue::ChooseTarget(const List& list, Schedule* schedule) {
  // Lists the receivers in the order of their first messages, so that candidate 0 is the choice of
  // a run without a schedule (Schedule::Choose()).
  candidates_.clear();
  for (const Message* m = list.head; m != nullptr; m = m->next) {
    if (std::find(candidates_.begin(), candidates_.end(), m->target) == candidates_.end())
      candidates_.push_back(m->target);
  }
  const size_t count = candidates_.size();
  if (count == 1) return candidates_[0];
  const size_t chosen = schedule->Choose(Schedule::Question::kNext, candidates_);
  ASSERT(chosen < count, "a schedule chose {} of {} candidates", chosen, count);
  return candidates_[chosen];
}

// Takes the first message for `target` from the list of `level`: the messages that are due now and
// have one class and priority.  REQUIRES: the list has a message for `target`.
Message* MessageQueue::TakeFirst(uint32_t level, ObjectId target) {
  List& list = levels_[level];
  Message* before = nullptr;
  Message* message = list.head;
  for (; message->target != target; message = message->next) before = message;
  (before == nullptr ? list.head : before->next) = message->next;
  if (list.tail == message) list.tail = before;
  return message;
}

void MessageQueue::Advance(int64_t time_us) {
  ASSERT(!HasDue() && time_us >= now_us_ && time_us <= NextTime(),
         "cannot go from {} us to {} us: {} messages queued, next at {} us", now_us_, time_us,
         size(), NextTime());
  now_us_ = time_us;
  while (!later_.empty() && later_.front().due_us == time_us) {
    const LaterMessage first = later_.front();
    std::pop_heap(later_.begin(), later_.end());
    later_.pop_back();
    Append(first.message, first.level);
  }
}

std::vector<OwnedMessage> MessageQueue::TakeIf(const std::function<bool(const Message&)>& matches) {
  std::vector<OwnedMessage> taken;
  for (uint32_t level = 0; level < kLevels; ++level) {
    // Empties the list of the level (the messages of one class and priority).  Then appends the
    // messages for which `matches` returns false again, in their old order.
    Message* message = std::exchange(levels_[level].head, nullptr);
    while (message != nullptr) {
      Message* const next = message->next;
      if (matches(*message)) {
        taken.emplace_back(message);
      } else {
        Append(message, level);
      }
      message = next;
    }
  }
  std::erase_if(later_, [&](const LaterMessage& entry) {
    if (!matches(*entry.message)) return false;
    taken.emplace_back(entry.message);
    return true;
  });
  std::make_heap(later_.begin(), later_.end());
  return taken;
}

void MessageQueue::ForEach(const std::function<void(const Message&)>& visit) const {
  for (const List& list : levels_) {
    for (const Message* m = list.head; m != nullptr; m = m->next) visit(*m);
  }
  // Sorts a copy of later_ (the messages that are not due yet), because later_ is a heap and so not
  // in the order of delivery.
  std::vector<LaterMessage> rest = later_;
  std::sort(rest.begin(), rest.end(),
            [](const LaterMessage& a, const LaterMessage& b) { return b < a; });
  for (const LaterMessage& entry : rest) visit(*entry.message);
}

}  // namespace openr_host
