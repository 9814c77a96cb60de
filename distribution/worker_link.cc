// The part of Worker that sends the effects of handlers to the master, as DDS samples: messages,
// calls without an answer (notes) and calls with an answer (questions).
#include <OPENR/ObjcommMessages.h>
#include <OPENR/RCRegion.h>
#include <fmt/format.h>
#include <sError.h>
#include <unistd.h>

#include <algorithm>
#include <exception>
#include <utility>

#include "distribution/worker.h"
#include "distribution/worker_call_list.h"
#include "runtime/base/assert.h"
#include "runtime/core/deferred_end.h"
#include "runtime/core/system.h"

namespace openr_host {
namespace {

constexpr uint32_t kPinRegion = WorkerCallList::NumberOf<&SystemCalls::PinRegion>();
constexpr uint32_t kUnpinRegion = WorkerCallList::NumberOf<&SystemCalls::UnpinRegion>();

}  // namespace

// Sends a sample, or ends the process if that fails.  An exception must not leave this function,
// because it would pass through the code of the running object.  That code might catch the
// exception, or the exception would look like an error of that code.
void Worker::Send(const openr_wire_ToMaster& to_master, bool batched) {
  try {
    batched ? channel_->SendBatched(to_master) : channel_->Send(to_master);
  } catch (const std::exception& error) {
    const size_t bulk_MB = BulkBytesOf(to_master) >> 20;
    if (bulk_MB + 1 < kSampleMax_MB)
      ExitWithError(fmt::format("could not send to the run: {}", error.what()));
    ExitWithError(
        fmt::format("could not send {} MB to the run, {} MB at once is the most: an object has "
                    "to notify less in one handler, or to stay in openr run",
                    bulk_MB, kSampleMax_MB));
  }
}

// Ends this process in the middle of a handler.  The effects of the handler cannot be sent to the
// master, so the handler must not go on.
void Worker::ExitWithError(const std::string& why) {
  options_.say(why);
  SayGoodbye(why);
  t_current = {};  // makes _exit() end the process and not only the handler
  _exit(1);
}

// Keeps the memory of `region` until the next sample is sent, because the object may release the
// region before that.
void Worker::KeepUntilSent(uint32_t region) {
  system_->regions().KeepCopy(region);
  pinned_.push_back(region);
}

// Removes the bytes of `part` if the sample that is being collected for the master already contains
// the same bytes.  One copy of a region's bytes is enough, even for several observers, because the
// master stores the bytes when it handles the first notification.
void Worker::SendOnce(openr_wire_NotifiedRegion* part) {
  const auto [first, is_first] = parts_in_sample_.try_emplace(part->region, *part);
  const openr_wire_NotifiedRegion& sent = first->second;
  if (!is_first && part->offset >= sent.offset &&
      uint64_t{part->offset} + part->size <= uint64_t{sent.offset} + sent.size)
    part->bytes = {};
}

openr_wire_PostedMessage Worker::Encode(const Message& message, int64_t delay_us) {
  openr_wire_PostedMessage posted{};
  posted.delay_us = delay_us;
  marshaller_->Encode(message, nullptr, &arena_, &posted.message);
  if (message.kind == PayloadKind::kNotify) {
    const auto& parts = posted.message.payload._u.notify.parts;
    for (uint32_t i = 0; i < parts._length; ++i) {
      KeepUntilSent(parts._buffer[i].region);
      SendOnce(&parts._buffer[i]);
    }
  } else if (message.kind == PayloadKind::kReady) {
    const auto& ready = *reinterpret_cast<const OReadyMessage*>(message.payload);
    for (int i = 0; i < ready.numOfData; ++i) KeepUntilSent(ready.rcRegion[i]->MemID());
  }
  return posted;
}

// Returns whether the master may refuse the message.  The master may refuse three kinds of
// messages: a reply, because the receiver may have closed the reply box; any message with --strict,
// which limits the number of waiting messages; and a message to an entry that does not exist.
bool Worker::MayBeRefused(const Message& message) {
  // Does not ask about messages that constructors have sent to their own object, because the master
  // does not know the entries of this object before it gets the sample Loaded.  The messages are in
  // this sample.
  if (message.target == loading_) return false;
  if (message.is_reply || system_->options().strict) return true;
  const std::pair<ObjectId, uint32_t> entry(message.target, message.selector);
  if (known_entries_.contains(entry)) return false;
  openr_wire_ToMaster to_master = NewToMaster(openr_wire_TO_MASTER_ENTRY);
  to_master.body._u.entry = {message.target, message.selector};
  Send(to_master);
  // If the receiver has the entry (status 1), remembers the entry, so that the worker need not ask
  // the master again.  Forget() removes the entries of an object that is replaced.
  if (WaitForAnswer().status != 1) return true;
  known_entries_.insert(entry);
  return false;
}

int32_t Worker::Post(OwnedMessage message, int64_t delay_us) {
  const DeferredEnd deferred_end;
  if (is_shutting_down_) return sFAIL;
  const bool may_be_refused = MayBeRefused(*message);
  const openr_wire_PostedMessage posted = Encode(*message, delay_us);
  int32_t error = sSUCCESS;
  // If the master may refuse the message, sends the message immediately, because the sender must
  // know the result.  All other messages are sent with the effects of the handler.
  if (may_be_refused) {
    openr_wire_ToMaster to_master = NewToMaster(openr_wire_TO_MASTER_POST);
    to_master.body._u.post = {t_current.object == nullptr ? kNoObject : t_current.object->id,
                              posted};
    MoveEffectsTo(&to_master);
    Send(to_master);
    error = static_cast<int32_t>(WaitForAnswer().status);
  } else {
    openr_wire_Effect effect{};
    effect._d = openr_wire_EFFECT_POST;
    effect._u.posted = posted;
    effects_.push_back(effect);
  }
  // Releases no received regions after a refusal.  A refused ready message has given nothing back,
  // so the observer keeps its regions.
  if (error == sSUCCESS) marshaller_->CompleteSend(*message);
  return error;
}

// Removes the latest call PinRegion() for `region` from the effects that are not sent yet, and
// returns true.  The worker was about to send a call of UnpinRegion() for the same region.  This
// call would undo the PinRegion(), so neither call needs to be sent.  Returns false if there is no
// such PinRegion().  Most observers take a region and give it back in one handler, so most pairs of
// these calls are never sent.
bool Worker::CancelPendingPin(uint64_t region) {
  const auto is_pin = [region](const openr_wire_Effect& effect) {
    return effect._d == openr_wire_EFFECT_NOTE && effect._u.note.kind == kPinRegion &&
           effect._u.note.numbers._buffer[0] == region;
  };
  // Searches from the end for the latest PinRegion() of this region.  An observer that gives its
  // region back in the same handler has pinned it last, so the latest call is the one to remove.
  const auto found = std::find_if(effects_.rbegin(), effects_.rend(), is_pin);
  if (found == effects_.rend()) return false;
  effects_.erase(std::next(found).base());
  return true;
}

void Worker::Tell(uint32_t function, const CallArguments& arguments) {
  const DeferredEnd deferred_end;
  ASSERT(arguments.bytes.empty(), "a call without an answer has no bytes on the wire");
  if (is_shutting_down_) return;
  ASSERT(function != kUnpinRegion || !arguments.numbers.empty());
  if (function == kUnpinRegion && CancelPendingPin(arguments.numbers.front())) return;
  openr_wire_Effect effect{};
  effect._d = openr_wire_EFFECT_NOTE;
  effect._u.note = {function, arena_.Numbers(arguments.numbers), arena_.Text(arguments.text)};
  effects_.push_back(effect);
}

CallResult Worker::Ask(uint32_t function, const CallArguments& arguments) {
  const DeferredEnd deferred_end;
  if (is_shutting_down_) return {};
  openr_wire_ToMaster to_master = NewToMaster(openr_wire_TO_MASTER_QUESTION);
  // Sends the effects that the handler has had so far (messages and notes) together with the
  // question, because the answer may depend on them.
  to_master.body._u.question = {t_current.object == nullptr ? kNoObject : t_current.object->id,
                                function, arena_.Numbers(arguments.numbers),
                                arena_.Text(arguments.text),
                                WireArena::View(arguments.bytes.data(), arguments.bytes.size())};
  MoveEffectsTo(&to_master);
  Send(to_master);
  return WaitForAnswer();
}

CallResult Worker::WaitForAnswer() {
  try {
    if (const ReceivedSample to_worker = Next(true)) {
      const openr_wire_Answer& answer = to_worker->body._u.answer;
      return {answer.status, VectorOf(answer.numbers), StringOf(answer.bytes)};
    }
  } catch (const std::exception& error) {
    ExitWithError(fmt::format("could not hear the run: {}", error.what()));
  }
  options_.say("the master is gone");
  t_current = {};  // makes _exit() end the process and not only the handler
  _exit(1);  // ends the process, because the handler that asked cannot go on without an answer
}

void Worker::RecordWait(uint64_t box, int64_t timeout_us, std::string_view why) {
  ASSERT(t_current.object != nullptr);
  // Only records what the handler is going to wait for.  The handler stops after this call, and
  // then SendStopped() tells the master.
  waits_[t_current.object->id] = {openr_wire_STOP_WAITS, box, timeout_us, 0, std::string(why)};
}

void Worker::RecordWaitForLine(uint64_t box, size_t size) {
  ASSERT(t_current.object != nullptr);
  waits_[t_current.object->id] = {openr_wire_STOP_READS, box, -1, size, ""};
}

}  // namespace openr_host
