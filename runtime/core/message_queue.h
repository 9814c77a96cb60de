// MessageQueue, which delivers messages in a total order, so that a run can be repeated exactly.
// The order has four steps: the due time; then the class; then the receiver's priority from its
// .ocf file, higher first; then the number that the message got when it was posted
// (docs/architecture.md, "The determinism contract").
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <vector>

#include "runtime/core/message.h"

namespace openr_host {

class Schedule;

// The queue of all messages of one System, and the pool from which messages are allocated.
class MessageQueue {
 public:
  MessageQueue();
  ~MessageQueue();  // REQUIRES: each message of the pool is queued or was given back
  MessageQueue(const MessageQueue&) = delete;
  MessageQueue& operator=(const MessageQueue&) = delete;

  // Returns a message from the pool.  The caller must set payload, target, selector and due time;
  // the other fields have the values of the parameters or their default values.
  OwnedMessage Allocate(ObjectId sender = kNoObject, uint64_t cause = 0,
                        MessageClass message_class = MessageClass::kObject) {
    return OwnedMessage(TakeFree(sender, cause, message_class));
  }

  // Queues `message`, whose due time, class and number are set.  `priority` is the priority of the
  // receiver, 0 to 255.  REQUIRES: message->due_us is not before the queue's clock (Advance()).
  void Push(OwnedMessage&& message, int priority) { Insert(message.release(), priority); }

  // Queues `message`, which is due now, in front of the other messages of its class and priority.
  // A caller that puts back several messages must begin with the last of them, so that they keep
  // their order.
  void PushFront(OwnedMessage message, int priority);

  // Takes the first message that is due now, or returns null if no message is due.  If several
  // messages of the first class and priority are due, `schedule` (schedule.h) chooses one of their
  // receivers, and the first message to this receiver is taken.
  OwnedMessage Pop(Schedule* schedule = nullptr) { return OwnedMessage(TakeDue(schedule)); }
  bool HasDue() const { return First() != nullptr; }
  // Returns the message that Pop() without a schedule would take; null if no message is due.
  const Message* First() const;

  // Returns the due time of the first message that is not due yet; INT64_MAX if all queued messages
  // are due.
  int64_t NextTime() const { return later_.empty() ? INT64_MAX : later_.front().due_us; }

  int64_t now_us() const { return now_us_; }  // the queue's clock
  // Sets the queue's clock to `time_us`.  REQUIRES: !HasDue(), time_us <= NextTime(), and `time_us`
  // is not before the clock.
  void Advance(int64_t time_us);

  // Returns the number of queued messages.  Counts them, so this function is slow.
  size_t size() const;

  // Takes every queued message for which `matches` returns true.  Returns first the messages that
  // are due, in the order of delivery, then the other messages in no particular order.
  std::vector<OwnedMessage> TakeIf(const std::function<bool(const Message&)>& matches);

  // Calls `visit` for every queued message in order of delivery.
  void ForEach(const std::function<void(const Message&)>& visit) const;

 private:
  static constexpr uint32_t kPriorities = 256;
  static constexpr uint32_t kLevels = kMessageClasses * kPriorities;

  struct List {
    Message* head = nullptr;  // null if the list is empty
    Message* tail = nullptr;  // the last message; has no meaning if the list is empty
  };
  struct LaterMessage {
    int64_t due_us;
    uint32_t level;
    uint64_t number;
    Message* message;
    // Returns true if `other` comes before this message in the order of delivery.  The order is
    // reversed, because std::push_heap() and similar functions put the greatest element first.
    bool operator<(const LaterMessage& other) const;
  };

  // Returns the level of a message, a number made of its class and `priority`, the priority of its
  // receiver.  Messages of a lower level are delivered first.  Any difference of class decides
  // before priorities do.
  static uint32_t LevelOf(const Message& message, int priority) {
    return static_cast<uint32_t>(message.message_class) * kPriorities + (kPriorities - 1) -
           static_cast<uint32_t>(priority);
  }
  Message* TakeFree(ObjectId sender, uint64_t cause, MessageClass message_class);
  void AddChunk();
  void Insert(Message* message, int priority);
  void InsertLater(Message* message, uint32_t level);
  Message* TakeDue(Schedule* schedule);
  void Append(Message* message, uint32_t level);
  void Mark(uint32_t level) {
    marks_[level / 64] |= uint64_t{1} << (level % 64);
    if (level < first_level_) first_level_ = level;
  }
  uint32_t NextMarked(uint32_t level) const;
  void LeaveFirstLevel();
  Message* TakeFirst(uint32_t level, ObjectId target);
  ObjectId ChooseTarget(const List& list, Schedule* schedule);

  int64_t now_us_ = 0;
  std::vector<List> levels_;  // messages that are due now, by level (LevelOf())
  // Bit i is 1 if the list of level i may have a message.  A level stands for a class and a
  // priority of messages (LevelOf()).  The bit stays 1 when the last message of the list is taken,
  // because most often the handler of this message posts another message to the same level.
  // TakeDue() clears the bit when it finds the list empty.
  uint64_t marks_[kLevels / 64] = {};
  uint32_t first_level_ = kLevels;   // the first level whose bit in marks_ is 1; kLevels if none is
  std::vector<LaterMessage> later_;  // messages that are not due yet, as a heap (std::push_heap)
  FreeMessages free_;                // the messages of the pool that nobody uses
  // The arrays that hold the messages of the pool, from which new messages are taken.
  std::vector<std::unique_ptr<Message[]>> chunks_;
  // The receivers among which ChooseTarget() lets a schedule choose.  The vector is a member so
  // that its memory is used again.
  std::vector<ObjectId> candidates_;
};

// ---- Functions that are called for every message of a run; therefore they are inline.

// Takes a message from the pool.  Sets its fields to the values of the parameters, and all other
// fields to their default values.
inline Message* MessageQueue::TakeFree(ObjectId sender, uint64_t cause,
                                       MessageClass message_class) {
  if (free_.empty()) [[unlikely]]
    AddChunk();
  Message* const message = free_.Take();
  message->number = 0;
  message->cause = cause;
  message->sender = sender;
  message->size = 0;
  message->reply_box = 0;
  message->payload_hash = 0;
  message->message_class = message_class;
  message->kind = PayloadKind::kBytes;
  message->is_reply = false;
  return message;
}

inline void MessageQueue::Insert(Message* message, int priority) {
  const uint32_t level = LevelOf(*message, priority);
  if (message->due_us == now_us_) [[likely]]
    Append(message, level);
  else
    InsertLater(message, level);
}

// Appends `message`, which is due now, to the queue's list for `level` (the messages of one class
// and priority).
inline void MessageQueue::Append(Message* message, uint32_t level) {
  List& list = levels_[level];
  message->next = nullptr;
  if (list.head == nullptr) {
    list.head = message;
    if (level != first_level_) Mark(level);
  } else {
    list.tail->next = message;
  }
  list.tail = message;
}

inline Message* MessageQueue::TakeDue(Schedule* schedule) {
  for (;;) {
    const uint32_t level = first_level_;
    if (level == kLevels) return nullptr;
    List& list = levels_[level];
    Message* const message = list.head;
    if (message == nullptr) {
      LeaveFirstLevel();
      continue;
    }
    if (schedule != nullptr && message != list.tail) [[unlikely]]
      return TakeFirst(level, ChooseTarget(list, schedule));
    list.head = message->next;
    return message;
  }
}

}  // namespace openr_host
