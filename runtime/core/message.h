// Messages and their total order.
//
// Messages are ordered by due time; then by class; then by the receiver's priority from its .ocf
// file, higher first; then by number (architecture.md, "Settled" 1).
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <vector>

namespace openr_host {

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

  // The largest number of bytes that a message can carry.  An ONotifyMessage of a 64-bit host needs
  // less.
  static constexpr size_t kPayloadMax = 384;
  alignas(16) unsigned char payload[kPayloadMax];
};

// The queue of all messages of one System, and the pool from which messages are allocated.
class MessageQueue {
 public:
  MessageQueue();
  ~MessageQueue();
  MessageQueue(const MessageQueue&) = delete;
  MessageQueue& operator=(const MessageQueue&) = delete;

  // Returns a message from the pool.  All fields are reset except the payload, sender, target,
  // selector and due time.  Release() gives the message back to the pool.
  Message* Allocate();
  void Release(Message* message);

  // Queues `message`, whose due time, class and number are set.  `priority` is the priority of the
  // receiver, 0 to 255.  REQUIRES: message->due_us is not before the clock.
  void Push(Message* message, int priority);

  // Queues `message`, which is due now, in front of the other messages of its class and priority.
  // To put back several messages in their order, begin with the last of them.
  void PushFront(Message* message, int priority);

  // Takes the first message that is due now, or returns null if none is due.  A `schedule` may
  // choose another receiver instead, which must have a message of the same class and priority as
  // the first message.
  Message* Pop(Schedule* schedule = nullptr);
  bool HasDue() const { return due_count_ > 0; }
  // Returns the message that Pop() without a schedule would take; null if none is due.
  const Message* First() const;

  // Returns the due time of the first message that is not due yet; INT64_MAX if there is none.
  int64_t NextTime() const { return later_.empty() ? INT64_MAX : later_.front().due_us; }

  // Sets the clock to `time_us`.  REQUIRES: !HasDue(), time_us <= NextTime(), and `time_us` is not
  // before the clock.
  void Advance(int64_t time_us);

  size_t size() const { return due_count_ + later_.size(); }

  // Removes every queued message for which `matches` returns true: calls `dispose` for the message,
  // then releases it.
  void RemoveIf(const std::function<bool(const Message&)>& matches,
                const std::function<void(const Message&)>& dispose);

  // Calls `visit` for every queued message in order of delivery.
  void ForEach(const std::function<void(const Message&)>& visit) const;

 private:
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
  void Append(Message* message, int level);
  int FirstLevel() const;
  Message* TakeFirst(int level, ObjectId target);
  ObjectId ChooseTarget(const List& list, Schedule* schedule);

  int64_t now_us_ = 0;
  size_t due_count_ = 0;
  std::vector<List> levels_;              // messages that are due now
  uint64_t occupied_[kLevels / 64] = {};  // bit i is 1 if the list of level i is not empty
  std::vector<Later> later_;              // messages that are not due yet; a heap
  std::vector<Message*> free_;            // the pool
  std::vector<Message*> chunks_;          // the arrays in which the messages of the pool lie
  // the receivers among which ChooseTarget() lets a schedule choose
  std::vector<ObjectId> candidates_;
};

}  // namespace openr_host
