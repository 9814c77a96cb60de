// Message: what objects, the runtime and the robots' devices send to each other.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>

namespace openr_host {

class FreeMessages;

// Index of an object in its System; -1 (kNoObject) is the System itself.
using ObjectId = int32_t;
constexpr ObjectId kNoObject = -1;

// The classes of messages, in order of delivery: if messages are due at the same time, messages of
// class kFrame are delivered first.
enum class MessageClass : uint8_t {
  kFrame = 0,   // begins a frame, a step of 8 ms of a robot's body
  kInput = 1,   // input from outside
  kVector = 2,  // from the robot's devices: sensor vectors, sounds, readies for commands
  kObject = 3,  // all other messages of objects
};
constexpr int kMessageClasses = 4;

// The largest number of bytes of a message that a program sends with the functions of MCOOP.h: the
// size of AperiosMessage.  These functions refuse longer messages.
constexpr size_t kMessageMax = 256;

// The kind of data in the payload of a message.  PayloadHash() (trace.h) hashes each kind in
// its own way.
enum class PayloadKind : uint8_t {
  kBytes,   // plain bytes, all initialised; its hash covers all of them
  kNotify,  // ONotifyMessage; its hash covers its data, not its addresses
  kReady,   // OReadyMessage; its hash covers its command, not its addresses
  kHashed,  // bytes with memory addresses in them; the sender sets Message::payload_hash
};

struct alignas(64) Message {
  int64_t due_us = 0;
  uint64_t number = 0;  // number of the message, from 1, in order of posting
  uint64_t cause = 0;   // number of the message whose handler posted this message; 0 at boot
  ObjectId sender = kNoObject;
  ObjectId target = kNoObject;
  uint32_t selector = 0;  // number of the receiver's entry, the function that handles the message
  uint32_t size = 0;      // number of bytes in `payload`
  // In a request, the number of the sender's reply box (requests.h).  In a reply, the number of the
  // target's reply box.  0 if the message is neither a request nor a reply.
  uint64_t reply_box = 0;
  uint64_t payload_hash = 0;  // hash of the payload; used only if `kind` is kHashed
  Message* next = nullptr;    // the next message in a list of MessageQueue
  MessageClass message_class = MessageClass::kObject;
  PayloadKind kind = PayloadKind::kBytes;
  bool is_reply = false;  // a reply goes into `reply_box` of the target and calls no entry
  // The pool to which the message goes back when it is no longer needed; null if the message is
  // from no pool.
  FreeMessages* pool = nullptr;

  // The largest number of bytes that a message can carry.  The robot's limit is 256; an
  // ONotifyMessage of a 64-bit host needs more, because its pointers have 8 bytes.
  static constexpr size_t kPayloadMax = 384;
  alignas(16) unsigned char payload[kPayloadMax];
};
// Every message begins at the start of a cache line, and its payload at byte 80.  A new field must
// fit into the padding before the payload.  If the payload moved, a message would take more cache
// lines, which would make every delivery slower.
static_assert(sizeof(void*) != 8 || offsetof(Message, payload) == 80);

// The messages of a MessageQueue's pool that nobody uses.
class FreeMessages {
 public:
  bool empty() const { return first_ == nullptr; }
  // Returns the newest free message, from which Message::next leads to the others; null if there is
  // none.
  const Message* first() const { return first_; }
  // Adds `message`, which is in no list.  The function is small, so that the compiler can inline
  // the many destructors of OwnedMessage, which call it.
  void Add(Message* message) {
    message->next = first_;
    first_ = message;
  }
  // Removes and returns the message that was added last.  REQUIRES: !empty().
  Message* Take() {
    Message* const message = first_;
    first_ = message->next;
    return message;
  }

 private:
  Message* first_ = nullptr;
};

// The deleter of OwnedMessage (the pointer that owns a message), which gives the message back to
// its pool.
struct ReturnToPool {
  void operator()(Message* message) const { message->pool->Add(message); }
};

// Owns a message that is in no queue, and gives the message back to its pool.  The pool must
// outlive the OwnedMessage.  The OwnedMessage of the message that a handler handles is a member of
// the Object and no local variable, because destructors on the stack of an abandoned handler never
// run.
using OwnedMessage = std::unique_ptr<Message, ReturnToPool>;

}  // namespace openr_host
