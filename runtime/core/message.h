// Messages and their total order.
//
// Messages are ordered by due time; then by class; then by the receiver's priority from its .ocf
// file, higher first; then by number (architecture.md, "Settled" 1).
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <vector>

namespace openr_host {

class MessageQueue;
class Schedule;

// Index of an object in its System; -1 is the system itself.
using ObjectId = int32_t;
constexpr ObjectId kNoObject = -1;

enum class MessageClass : uint8_t {
  kFrame = 0,   // the begin of a frame of a robot's body
  kInput = 1,   // input from outside
  kVector = 2,  // messages of the robot's devices: sensor vectors, sounds, readies for commands
  kObject = 3,  // messages of objects
};
constexpr int kMessageClasses = 4;

// How the payload is hashed for the trace; see PayloadHash() in trace.h.
enum class PayloadKind : uint8_t {
  kBytes,   // plain initialised bytes
  kNotify,  // ONotifyMessage: the bytes of its regions
  kReady,   // OReadyMessage: command and counts
  kHashed,  // bytes that hold addresses: Message::payload_hash is used, which the sender has set
};

struct Message {
  int64_t due_us = 0;
  uint64_t number = 0;  // number of the message, from 1, in order of posting
  uint64_t cause = 0;   // number of the message whose handler posted this message; 0 at boot
  ObjectId sender = kNoObject;
  ObjectId target = kNoObject;
  uint32_t selector = 0;
  uint32_t size = 0;          // bytes of payload
  uint64_t reply_box = 0;     // the box that receives the reply; 0: no reply is expected
  uint64_t payload_hash = 0;  // the hash that is used for kHashed
  Message* next = nullptr;    // the next message in a list of MessageQueue
  MessageClass message_class = MessageClass::kObject;
  PayloadKind kind = PayloadKind::kBytes;
  bool is_reply = false;  // a reply to `reply_box` of the target, which calls no entry
  // the queue whose pool the message is from, set by Allocate(); null: from no pool
  MessageQueue* pool = nullptr;

  // The largest number of bytes that a message can carry.  An ONotifyMessage of a 64-bit host needs
  // less.
  static constexpr size_t kPayloadMax = 384;
  alignas(16) unsigned char payload[kPayloadMax];
};
// A handler's time depends on the cache lines that a message takes, so a new field must fit into
// the padding before the payload.
static_assert(sizeof(void*) != 8 || sizeof(Message) == 80 + Message::kPayloadMax);

// Gives a message back to its pool.
struct ReturnToPool {
  void operator()(Message* message) const;
};

// A message that is in no queue.  Its pool must outlive it.  Because the objects on the stack of an
// abandoned handler are never destroyed, the message that a handler runs for belongs to the state
// of its object (HandlerState::running).
using OwnedMessage = std::unique_ptr<Message, ReturnToPool>;

// The queue of all messages of one System, and the pool from which messages are allocated.
class MessageQueue {
 public:
  MessageQueue();
  ~MessageQueue();  // REQUIRES: all messages of the pool are queued or back
  MessageQueue(const MessageQueue&) = delete;
  MessageQueue& operator=(const MessageQueue&) = delete;

  // Returns a message from the pool.  All fields are reset except the payload, sender, target,
  // selector and due time.
  OwnedMessage Allocate();

  // Queues `message`, whose due time, class and number are set.  `priority` is the priority of the
  // receiver, 0 to 255.  REQUIRES: message->due_us is not before the clock.
  void Push(OwnedMessage&& message, int priority);

  // Queues `message`, which is due now, in front of the other messages of its class and priority.
  // To put back several messages in their order, begin with the last of them.
  void PushFront(OwnedMessage message, int priority);

  // Takes the first message that is due now, or returns null if none is due.  A `schedule` may
  // choose another receiver instead, which must have a message of the same class and priority as
  // the first message.
  OwnedMessage Pop(Schedule* schedule = nullptr);
  bool HasDue() const { return due_count_ > 0; }
  // Returns the message that Pop() without a schedule would take; null if none is due.
  const Message* First() const;

  // Returns the due time of the first message that is not due yet; INT64_MAX if there is none.
  int64_t NextTime() const { return later_.empty() ? INT64_MAX : later_.front().due_us; }

  // Sets the clock to `time_us`.  REQUIRES: !HasDue(), time_us <= NextTime(), and `time_us` is not
  // before the clock.
  void Advance(int64_t time_us);

  size_t size() const { return due_count_ + later_.size(); }

  // Takes every queued message for which `matches` returns true.  Returns those that are due in
  // order of delivery, then the others in no order.
  std::vector<OwnedMessage> TakeIf(const std::function<bool(const Message&)>& matches);

  // Calls `visit` for every queued message in order of delivery.
  void ForEach(const std::function<void(const Message&)>& visit) const;

 private:
  friend struct ReturnToPool;

  static constexpr int kPriorities = 256;
  static constexpr int kLevels = kMessageClasses * kPriorities;

  struct List {
    Message* head = nullptr;
    Message* tail = nullptr;
  };
  struct Later {
    int64_t due_us;
    int level;
    uint64_t number;
    Message* message;
    // true if `other` is due first, as the functions for heaps need it
    bool operator<(const Later& other) const;
  };

  // A level is a class and a priority; level 0 is delivered first.
  static int LevelOf(const Message& message, int priority) {
    return static_cast<int>(message.message_class) * kPriorities + (kPriorities - 1 - priority);
  }
  // Gives `message`, which is in no list, back to the pool.  Small enough for a compiler to inline
  // the destructors of all OwnedMessages, of which a notification has many.
  void Release(Message* message) {
    message->next = free_;
    free_ = message;
  }
  void Append(Message* message, int level);
  int FirstLevel() const;
  Message* TakeFirst(int level, ObjectId target);
  ObjectId ChooseTarget(const List& list, Schedule* schedule);

  int64_t now_us_ = 0;
  size_t due_count_ = 0;
  std::vector<List> levels_;              // messages that are due now
  uint64_t occupied_[kLevels / 64] = {};  // bit i is 1 if the list of level i is not empty
  std::vector<Later> later_;              // messages that are not due yet; a heap
  Message* free_ = nullptr;               // the first free message; Message::next has the others
  // the arrays in which the messages of the pool lie
  std::vector<std::unique_ptr<Message[]>> chunks_;
  // the receivers among which ChooseTarget() lets a schedule choose
  std::vector<ObjectId> candidates_;
};

inline void ReturnToPool::operator()(Message* message) const { message->pool->Release(message); }

}  // namespace openr_host
