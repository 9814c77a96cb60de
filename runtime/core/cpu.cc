#include "runtime/core/cpu.h"

#include <OPENR/OPENR.h>
#include <fmt/format.h>
#include <sError.h>

#include <utility>

#include "runtime/base/assert.h"
#include "runtime/base/hasher.h"
#include "runtime/core/connection_messages.h"
#include "runtime/core/system.h"

namespace openr_host {
namespace {

// Handles a message of `sender` that Post() refuses when it leaves the outbox.  The program cannot
// handle this refusal, because the function with which the program posted the message has already
// returned success.
void HandleRefused(Object* sender, const Message& message) {
  if (message.kind == PayloadKind::kNotify || message.kind == PayloadKind::kReady)
    HandleLateRefusal(sender, message);
  if (message.reply_box == 0) return;
  // Nothing will reply to the request, so the wait of the object that has sent it ends, as at a
  // time-out.
  System* const system = sender->system;
  const CurrentScope scope(system, system->object(message.sender));
  system->calls().BeginWait(message.reply_box, 0, "");
}

}  // namespace

int64_t CostModel::FrameUs() const { return kFrameUs; }

bool Cpu::IsFreeFor(const Object& object) const {
  return jobs_.empty() || object.limits().priority > jobs_.back().object->limits().priority;
}

void Cpu::Wait(Object* object, OwnedMessage message, int64_t now_us) {
  object->processor().NoteStarving(now_us);
  waiting_.push_back(std::move(message));
}

std::vector<OwnedMessage> Cpu::TakeMessagesTo(ObjectId id) {
  std::vector<OwnedMessage> taken;
  for (OwnedMessage& message : waiting_) {
    if (message->target == id) taken.push_back(std::move(message));
  }
  std::erase(waiting_, nullptr);
  return taken;
}

void Cpu::Grant(Object* object, int64_t now_us) {
  const int64_t since_us = object->processor().EndStarving();
  if (since_us >= 0 && now_us - since_us > kStarvedUs) {
    system_->AddFindingAbout(object, Severity::kWarning,
                             fmt::format("got no processor time for {:.3f} s: others of the same "
                                         "or a higher priority did not leave it any",
                                         static_cast<double>(now_us - since_us) * 1e-6));
  }
}

void Cpu::Begin(Object* object, uint32_t selector, int64_t cost_us, int64_t now_us) {
  ASSERT(cost_us > 0 && IsFreeFor(*object) && !object->delivery().is_busy(),
         "{} begins a handler of {} us", object->name, cost_us);
  // Adds no finding about DoInit, DoStart, DoStop and DoDestroy, even if they take long, because
  // they run only when the robot starts or ends.
  if (cost_us > kLongHandlerUs && selector > oentryDESTROY) {
    system_->AddFindingAbout(
        object, Severity::kWarning,
        fmt::format("{} takes longer than the {} ms between two sensor vectors: this object loses "
                    "some, and those of its priority or a lower one stand still; do the work in "
                    "parts",
                    object->EntryName(selector), kLongHandlerUs / 1000));
  }
  // The new handler interrupts the handler that has the processor.  The remaining time of the
  // interrupted handler becomes shorter by the time since it last got the processor.
  if (!jobs_.empty()) jobs_.back().left_us -= now_us - jobs_.back().since_us;
  jobs_.push_back({object, cost_us, now_us});
  object->delivery().set_busy(true);
}

int64_t Cpu::EndUs() const {
  return jobs_.empty() ? INT64_MAX : jobs_.back().since_us + jobs_.back().left_us;
}

void Cpu::End(int64_t now_us) {
  ASSERT(EndUs() == now_us);
  Object* const object = jobs_.back().object;
  jobs_.pop_back();
  if (!jobs_.empty()) jobs_.back().since_us = now_us;
  object->delivery().set_busy(false);
  PostOutbox(object);
  // Puts the messages back at the front of the queue: those that were held for the object, and
  // those that waited for the processor.  They are older than all messages due now.  Begins with
  // the newest message, so that afterwards the oldest is at the front.
  object->ReturnHeld();
  while (!waiting_.empty()) {
    system_->Readmit(std::move(waiting_.back()));
    waiting_.pop_back();
  }
}

// Post() sends the messages and does not put them into the outbox again, because `object` is not
// busy any more.
void PostOutbox(Object* object) {
  ASSERT(!object->delivery().is_busy(), "{} still has the processor", object->name);
  for (ProcessorState::Outgoing& outgoing : object->processor().TakeOutbox()) {
    const Message* const message = outgoing.message.get();
    // A message that Post() refuses stays in `outgoing`, so `message` is valid in HandleRefused().
    if (object->system->Post(std::move(outgoing.message), outgoing.delay_us) != sSUCCESS)
      HandleRefused(object, *message);
  }
}

void Cpu::HashState(Hasher* hasher) const {
  for (const Job& job : jobs_) {
    hasher->Add(job.object->id);
    hasher->Add(job.left_us);
    hasher->Add(job.since_us);
  }
  for (const OwnedMessage& message : waiting_) hasher->Add(message->number);
}

}  // namespace openr_host
