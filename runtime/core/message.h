// Messages and their total order.
//
// Key: due time; then class; then the receiver's priority from its .ocf file,
// higher first; then number (architecture.md, "Settled" 1).
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
  kFrame = 0,   // a body's frame
  kInput = 1,   // what comes from outside
  kVector = 2,  // finished command vectors, sensor vectors
  kObject = 3,  // messages of objects
};
constexpr int kMessageClasses = 4;

// How the payload is hashed for the trace; see PayloadHash() in trace.h.
enum class PayloadKind : uint8_t {
  kBytes,   // plain initialised bytes
  kNotify,  // ONotifyMessage: the bytes of its regions
  kReady,   // OReadyMessage: command and counts
  kHashed,  // holds addresses; the sender gave the hash
};

struct Message {
  int64_t due_us = 0;
  uint64_t number = 0;  // from 1, in order of posting
  uint64_t cause = 0;   // number of the message whose handler posted it; 0 at boot
  ObjectId sender = kNoObject;
  ObjectId target = kNoObject;
  uint32_t selector = 0;
  uint32_t size = 0;          // bytes of payload
  uint64_t reply_box = 0;     // not 0: somebody waits for Reply()
  uint64_t payload_hash = 0;  // for kHashed
  Message* next = nullptr;
  MessageClass message_class = MessageClass::kObject;
  PayloadKind kind = PayloadKind::kBytes;
  bool is_reply = false;  // answers reply_box, goes to whoever waits for it

  // Most bytes a message can carry here: an ONotifyMessage of a 64-bit host.
  static constexpr size_t kPayloadMax = 384;
  alignas(16) unsigned char payload[kPayloadMax];
};

// All messages of one System, in order.  Messages come from its pool.
class MessageQueue {
 public:
  MessageQueue();
  ~MessageQueue();
  MessageQueue(const MessageQueue&) = delete;
  MessageQueue& operator=(const MessageQueue&) = delete;

  // A message with every field but the payload reset.  Owned by the queue;
  // Release() gives it back.
  Message* Allocate();
  void Release(Message* message);

  // Adds a message with its final key.  `priority` is its receiver's.
  // REQUIRES: due_us >= now of the last Advance.
  void Push(Message* message, int priority);

  // Puts back messages taken earlier at this instant's head, keeping their order.
  void PushFront(Message* message, int priority);

  // The first message due now; null when there is none.  With a schedule: the first one
  // of the receiver it chooses among those that are as urgent as the first.
  Message* Pop(Schedule* schedule = nullptr);
  bool HasDue() const { return due_count_ > 0; }
  // What Pop() without a schedule gives next, which stays; null when nothing is due.
  const Message* First() const;

  // When the next message that is not due yet is due; INT64_MAX when there is none.
  int64_t NextTime() const { return later_.empty() ? INT64_MAX : later_.front().due_us; }

  // Moves the clock.  REQUIRES: !HasDue() and time_us <= NextTime().
  void Advance(int64_t time_us);

  size_t size() const { return due_count_ + later_.size(); }

  // Takes out every waiting message that `matches`; `dispose` sees each before it is
  // released.
  void RemoveIf(const std::function<bool(const Message&)>& matches,
                const std::function<void(const Message&)>& dispose);

  // Calls `visit` for every waiting message in order of delivery.
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
    bool operator<(const Later& other) const;  // for a heap with the first on top
  };

  static int LevelOf(const Message& message, int priority) {
    return static_cast<int>(message.message_class) * kPriorities + (kPriorities - 1 - priority);
  }
  void Append(Message* message, int level);
  int FirstLevel() const;
  Message* TakeFirst(int level, ObjectId target);
  ObjectId ChooseTarget(const List& list, Schedule* schedule);

  int64_t now_us_ = 0;
  size_t due_count_ = 0;
  std::vector<List> levels_;
  uint64_t occupied_[kLevels / 64] = {};
  std::vector<Later> later_;  // heap
  std::vector<Message*> free_;
  std::vector<Message*> chunks_;
  std::vector<ObjectId> candidates_;  // of ChooseTarget()
};

}  // namespace openr_host
