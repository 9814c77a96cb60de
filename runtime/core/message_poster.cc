#include "runtime/core/message_poster.h"

#include <fmt/format.h>
#include <sError.h>

#include <utility>

#include "runtime/base/assert.h"
#include "runtime/core/system.h"

namespace openr_host {

MessagePoster::MessagePoster(bool are_calls_local, uint64_t seed)
    : are_calls_local_(are_calls_local) {
  if (seed != SystemOptions().seed) {
    seed_schedule_ = std::make_unique<SeedSchedule>(seed);
    schedule_ = seed_schedule_.get();
  }
  CheckPosts();
}

void MessagePoster::CheckPosts() {
  are_posts_free_ = are_calls_local_ && schedule_ == nullptr && !has_processors_;
}

// Refuses a message to an entry that the target does not have.  The usual cause: the stub (the
// generated code with the entries of an object) of the sender or of the target was made from
// another stub.cfg than its sources need.
int32_t MessagePoster::RefuseSelector(const Message& message, const Object& target) {
  target.system->AddFindingAbout(
      &target, Severity::kError,
      fmt::format("MCOOPMailer::intraDeliver selector is out of range: sel={}, "
                  "sError = {}; the sender's table and this object's stub do not "
                  "belong together",
                  message.selector, sEXCEEDEDSIZEOFENTRYTABLE));
  return sEXCEEDEDSIZEOFENTRYTABLE;
}

// Refuses a message as if the queue of `target` were full, because the schedule (schedule.h)
// demands that this post fails.
int32_t MessagePoster::RefuseAsFull(const Message& message, Object* target) {
  target->system->AddFindingAbout(
      target, Severity::kWarning,
      fmt::format("sel={} ({}): the schedule refuses a message, as a full queue "
                  "does, sError = 13",
                  message.selector, target->EntryName(message.selector)));
  target->statistics().NoteDropped();
  return sFULLMSGQENTRY;
}

// Reports that the queue of `target` is full.  Returns sSUCCESS if the message is accepted
// nevertheless, as it is without --strict.
int32_t MessagePoster::ReportFullQueue(const Message& message, Object* target) {
  const bool is_strict = target->system->options().strict;
  target->system->AddFindingAbout(
      target, is_strict ? Severity::kError : Severity::kWarning,
      fmt::format("MCOOPMailer::intraDeliver Exceed max size of queue: queueSize={}, "
                  "sel={} ({}); the robot refuses the message, sError = 13",
                  target->queue_max(), message.selector, target->EntryName(message.selector)));
  if (!is_strict) return sSUCCESS;
  target->statistics().NoteDropped();
  return sFULLMSGQENTRY;
}

int32_t MessagePoster::Post(OwnedMessage&& message, Object* target, int64_t delay_us) {
  if (target == nullptr) return PostToUnknown(std::move(message), delay_us);
  ASSERT(delay_us >= 0, "message to {} in {} us", target->name, delay_us);
  // While the sender's handler still takes processor time, the message waits in the sender's
  // outbox.  Cpu::End() posts it when that time is over.
  if (Object* const self = t_current.object; self != nullptr && self->delivery().is_busy()) {
    self->processor().KeepOutgoing(std::move(message), delay_us);
    return sSUCCESS;
  }
  if (!message->is_reply) {
    if (message->selector >= target->entry_count() && !target->HasEntry(message->selector))
      return RefuseSelector(*message, *target);
    // Returns whether the message makes a system object (a part of the robot) go on with its own
    // work, because this object has posted the message to itself, or the System has posted it.  A
    // schedule must not refuse this message, because the system object would then stop working.
    const auto is_own_work = [&] {
      return target->is_system() && (message->sender == target->id || message->sender == kNoObject);
    };
    if (schedule_ != nullptr && !is_own_work() && schedule_->Refuses(*message))
      return RefuseAsFull(*message, target);
    if (target->IsQueueFull()) {
      const int32_t error = ReportFullQueue(*message, target);
      if (error != sSUCCESS) return error;
    }
    target->NoteQueued();
  }
  Number(message.get(), delay_us);
  if (schedule_ != nullptr)
    message->due_us += schedule_->ExtraDelayUs(*message, queue_.now_us(), delay_us);
  queue_.Push(std::move(message), target->limits().priority);
  return sSUCCESS;
}

int32_t MessagePoster::PostToUnknown(OwnedMessage&& message, int64_t delay_us) {
  Object* const self = t_current.object;
  if (self == nullptr || self->id != message->target) return sINVALIDOID;
  self->processor().KeepOutgoing(std::move(message), delay_us);
  return sSUCCESS;
}

void MessagePoster::Readmit(OwnedMessage message, const Object& target) {
  message->due_us = queue_.now_us();
  queue_.PushFront(std::move(message), target.limits().priority);
}

}  // namespace openr_host
