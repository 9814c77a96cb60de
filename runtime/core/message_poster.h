// MessagePoster: posts messages.  It has the queue, refuses messages that the robot refuses, and
// gives each message its number and its due time.
#pragma once

#include <cstdint>
#include <memory>

#include "runtime/core/message.h"
#include "runtime/core/message_queue.h"
#include "runtime/core/object.h"
#include "runtime/core/schedule.h"

namespace openr_host {

class MessagePoster {
 public:
  // `are_calls_local` tells whether System::calls() is a LocalCalls, which queues the messages of
  // handlers in this process.  Unless `seed` is the default of SystemOptions::seed, messages follow
  // a schedule (schedule.h) made from `seed`.
  MessagePoster(bool are_calls_local, uint64_t seed);
  MessagePoster(const MessagePoster&) = delete;
  MessagePoster& operator=(const MessagePoster&) = delete;

  MessageQueue& queue() { return queue_; }
  const MessageQueue& queue() const { return queue_; }

  // Queues `message` for its receiver `target` without delay and returns true.  The queue then owns
  // `message`.  If `message` may have to be refused or delayed, does nothing and returns false.
  // REQUIRES: `message` is no reply.
  bool PostAtOnce(Message* message, Object* target);
  // Queues `message` in the queue of this process.  `target` is its receiver; null if no object has
  // the id of the receiver.  Called by LocalCalls::Post().  Returns an sError as System::Post()
  // does.  A refused message stays in `message`.  REQUIRES: delay_us >= 0.
  int32_t Post(OwnedMessage&& message, Object* target, int64_t delay_us);
  // Handles a message to an object that is not in the table of objects.  If the constructors of
  // this object run now and have sent the message to their own object, keeps the message in the
  // object's outbox until the object is in the table (LoadImage()), and returns sSUCCESS.
  // Otherwise returns sINVALIDOID.
  static int32_t PostToUnknown(OwnedMessage&& message, int64_t delay_us);
  // Puts `message` back into the queue after it was held: by a gate, or because `target` could not
  // handle it yet or waited for the processor (cpu.h).  The message is due now, and is delivered
  // before all others of its class and priority.
  void Readmit(OwnedMessage message, const Object& target);

  // Replaces the schedule that the seed has chosen; see System::set_schedule().
  void set_schedule(Schedule* schedule) {
    schedule_ = schedule;
    CheckPosts();
  }
  Schedule* schedule() const { return schedule_; }  // null if there is no schedule

  // Records that the robots have processors (cpu.h), that is, that handlers take time.  From then
  // on, a message that is posted while its sender's handler has the processor waits in the sender's
  // outbox.
  void NoteProcessors() {
    has_processors_ = true;
    CheckPosts();
  }

  // Returns the time to add to the due time of a message that is posted now: 1 us if more messages
  // were delivered at this instant than SystemOptions::free_deliveries, otherwise 0.
  int64_t crowding_delay_us() const { return crowding_delay_us_; }
  void set_crowding_delay_us(int64_t delay_us) { crowding_delay_us_ = delay_us; }

  // Returns the number of the message that was posted last; 0 if none was posted.
  uint64_t last_number() const { return last_number_; }

 private:
  static int32_t RefuseSelector(const Message& message, const Object& target);
  static int32_t RefuseAsFull(const Message& message, Object* target);
  static int32_t ReportFullQueue(const Message& message, Object* target);
  void CheckPosts();
  // Gives `message`, which is posted now, its number and its due time.
  void Number(Message* message, int64_t delay_us) {
    message->number = ++last_number_;
    message->due_us = queue_.now_us() + delay_us + crowding_delay_us_;
  }

  // True if a message can be queued at once unless its receiver has no such entry or a full queue.
  // False if other reasons can prevent this: a master process to which messages are sent first, a
  // schedule, or a model of the processor.
  bool are_posts_free_ = false;
  const bool are_calls_local_;
  bool has_processors_ = false;
  uint64_t last_number_ = 0;
  int64_t crowding_delay_us_ = 0;
  std::unique_ptr<SeedSchedule> seed_schedule_;
  Schedule* schedule_ = nullptr;
  MessageQueue queue_;
};

[[gnu::always_inline]] inline bool MessagePoster::PostAtOnce(Message* message, Object* target) {
  const bool is_common = are_posts_free_ && target != nullptr &&
                         message->selector < target->entry_count() && !target->IsQueueFull();
  if (!is_common) [[unlikely]]
    return false;
  target->NoteQueued();
  Number(message, 0);
  queue_.Push(OwnedMessage(message), target->limits().priority);
  return true;
}

}  // namespace openr_host
