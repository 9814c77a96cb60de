// Applies the effects of handlers in a worker and answers its questions.
//
// Everything is checked before it is applied: a worker may only speak for its own objects, regions
// and robots.
#include <fmt/format.h>

#include <algorithm>

#include "distribution/questions.h"
#include "distribution/remote_object.h"
#include "distribution/remote_process.h"
#include "runtime/core/api.h"
#include "runtime/core/system.h"

namespace openr_host {
namespace {

// Longer delays and timeouts are refused.
constexpr int64_t kDelayMaxUs = int64_t{1} << 53;

}  // namespace

// Handles a sample that does not end a handler.  Returns false if it is none of these.
bool RemoteProcess::HandleRequest(const openr_wire_ToMaster& to_master) {
  switch (to_master.body._d) {
    case openr_wire_TO_MASTER_CONSOLE:
      system_->Print(StringOf(to_master.body._u.console_text));
      return true;
    case openr_wire_TO_MASTER_QUESTION: {
      const openr_wire_Question& in = to_master.body._u.question;
      Object* const self = ObjectOf(in.object);
      // Effects of the handler before its question come first, as in one process.
      Apply(to_master, self);
      const CurrentScope scope(system_, self);
      SendAnswer(AnswerQuestion(system_, self,
                                {static_cast<QuestionKind>(in.kind), VectorOf(in.numbers),
                                 StringOf(in.text), StringOf(in.bytes)}));
      return true;
    }
    case openr_wire_TO_MASTER_ENTRY: {
      const Object* const object = system_->object(to_master.body._u.entry.object);
      const bool has = object != nullptr && object->HasEntry(to_master.body._u.entry.selector);
      SendAnswer({has ? 1 : 0});
      return true;
    }
    case openr_wire_TO_MASTER_POST: {
      Object* const self = ObjectOf(to_master.body._u.post.object);
      Apply(to_master, self);
      SendAnswer({Post(to_master.body._u.post.posted, self)});
      return true;
    }
    case openr_wire_TO_MASTER_STOPPED:
      if (to_master.body._u.stopped.timeout_us > kDelayMaxUs) Refuse("a wait until another time");
      return false;
    default:
      return false;
  }
}

Object* RemoteProcess::ObjectOf(ObjectId id) {
  const auto found = objects_.find(id);
  if (found == objects_.end()) Refuse("a request of an object that is not its own");
  return found->second;
}

void RemoteProcess::SendAnswer(const Answer& answer) {
  WireArena arena;
  openr_wire_ToWorker to_worker = NewToWorker(openr_wire_TO_WORKER_ANSWER);
  to_worker.body._u.answer = {answer.status, arena.Numbers(answer.numbers),
                              WireArena::View(answer.bytes.data(), answer.bytes.size())};
  Send(to_worker);
}

void RemoteProcess::Apply(const openr_wire_ToMaster& to_master, Object* self) {
  const CurrentScope scope(system_, self);
  for (uint32_t i = 0; i < to_master.effects._length; ++i) {
    const openr_wire_Effect& effect = to_master.effects._buffer[i];
    if (effect._d == openr_wire_EFFECT_POST) {
      Post(effect._u.posted, self);
    } else {
      const openr_wire_Note& note = effect._u.note;
      ApplyNote(static_cast<NoteKind>(note.kind), VectorOf(note.numbers), StringOf(note.text));
    }
  }
}

// Whether `message` answers the request that the handler of `self` is serving, or forwards that
// request to another object.
bool RemoteProcess::Answers(const Message& message, const Object* self) {
  const Message* const request = self == nullptr ? nullptr : self->running;
  return request != nullptr && message.reply_box != 0 && message.reply_box == request->reply_box &&
         (message.is_reply ? message.target : message.sender) == request->sender;
}

// Whether the worker may send bytes of `region`: it is one of its own, or was sent to it.
bool RemoteProcess::MayUse(uint32_t region) const {
  return IsOwn(region) || marshaller_->HasExported(region);
}

// Whether an object of the worker owns the region or has made it.  An object may make a region and
// give it to another one.
bool RemoteProcess::IsOwn(uint32_t region) const {
  const RegionTable& regions = system_->regions();
  return objects_.contains(regions.OwnerOf(region)) || objects_.contains(regions.MakerOf(region));
}

// Checks that the sender of `in` is an object of this worker, and also the subject or observer.  A
// forwarded request keeps the name of the original sender.
void RemoteProcess::CheckEnds(const openr_wire_Message& in, const Object* self) {
  const auto is_own = [&](ObjectId id) {
    return self == nullptr ? id == kNoObject || objects_.contains(id) : id == self->id;
  };
  const Message* const request = self == nullptr ? nullptr : self->running;
  const bool is_forwarded = request != nullptr && !in.is_reply && in.reply_box != 0 &&
                            in.reply_box == request->reply_box && in.sender == request->sender;
  if (!is_own(in.sender) && !is_forwarded) Refuse("a message in the name of another object");
  // An object id that no object has is accepted: a subject or observer without an entry sends such
  // ids.
  const auto is_others = [&](ObjectId id) { return !is_own(id) && system_->object(id) != nullptr; };
  if (in.payload._d == openr_wire_PAYLOAD_NOTIFY && is_others(in.payload._u.notify.subject))
    Refuse("a notification of another object's subject");
  if (in.payload._d == openr_wire_PAYLOAD_READY && is_others(in.payload._u.ready.observer))
    Refuse("a ready of another object's observer");
}

void RemoteProcess::Check(const openr_wire_Message& in, const Object* self) {
  CheckEnds(in, self);
  const auto check_region = [this](uint32_t region) {
    if (system_->regions().BaseOf(region) != nullptr && !MayUse(region))
      Refuse(fmt::format("bytes of region {:#x}, which it has not", region));
  };
  if (in.payload._d == openr_wire_PAYLOAD_ANT) check_region(in.payload._u.ant.region);
  if (in.payload._d != openr_wire_PAYLOAD_NOTIFY) return;
  const auto& parts = in.payload._u.notify.parts;
  for (uint32_t i = 0; i < parts._length; ++i) check_region(parts._buffer[i].region);
}

int32_t RemoteProcess::Post(const openr_wire_PostedMessage& posted, Object* self) {
  Check(posted.message, self);
  const CurrentScope scope(system_, self);
  Message* const message = system_->NewMessage(posted.message.target, posted.message.selector);
  // Decode() overwrites these fields with those that the worker sent.
  const MessageClass message_class = message->message_class;
  const uint64_t cause = message->cause;
  const std::string problem = marshaller_->Decode(posted.message, message);
  marshaller_->ReleaseSample();
  if (!problem.empty()) Refuse(problem);
  if (posted.delay_us < 0 || posted.delay_us > kDelayMaxUs) Refuse("a message for another time");
  // The System gives its own number and cause, as it does for an object in this process.
  message->number = 0;
  message->cause = cause;
  message->message_class = message_class;
  if (message->is_reply) {
    // A reply to a box that has been closed meanwhile is refused, as in one process.
    const Object* const asker = system_->object(message->target);
    if (asker == nullptr || !asker->boxes.contains(message->reply_box)) {
      system_->queue().Release(message);
      return sRBOXWASCLEANED;
    }
  }
  const bool is_notify = message->kind == PayloadKind::kNotify && self != nullptr;
  const StandingReady used = {is_notify ? posted.message.payload._u.notify.selector : 0,
                              message->target, message->selector};
  const bool answers = Answers(*message, self);
  const int32_t error = system_->Post(message, posted.delay_us);
  // The request has its answer.  If the worker is lost later, the stand-in must not send an empty
  // one.
  if (answers && error == sSUCCESS) self->running->reply_box = 0;
  // The observer has its notification and must assert ready again.
  if (is_notify && error == sSUCCESS) objects_.at(self->id)->UseReady(used);
  return error;
}

void RemoteProcess::Unpin(uint32_t region) {
  const auto pins = pins_.find(region);
  // Each unpin must have its pin, or a worker could free regions of other objects.
  if (pins == pins_.end()) Refuse("a region given back twice");
  if (--pins->second == 0) pins_.erase(pins);
  system_->regions().Unpin(region);
}

void RemoteProcess::EndRobot(NoteKind kind, int robot, const RunEnd& why) {
  if (kind == NoteKind::kPowerOff) {
    system_->PowerOff(robot, why);
  } else {
    system_->Shutdown(robot, why);
  }
}

void RemoteProcess::ApplyNote(NoteKind kind, const std::vector<uint64_t>& numbers,
                              const std::string& text) {
  const auto number = [&](size_t i) { return i < numbers.size() ? numbers[i] : 0; };
  const auto region = static_cast<uint32_t>(number(0));
  Object* const self = t_current.object;
  switch (kind) {
    case NoteKind::kFinding:
      // An unknown severity is taken for an error.
      system_->AddFindingAbout(system_->object(static_cast<ObjectId>(number(1)) - 1),
                               number(0) <= static_cast<uint64_t>(Severity::kNote)
                                   ? static_cast<Severity>(number(0))
                                   : Severity::kError,
                               text);
      return;
    case NoteKind::kShutdown:
    case NoteKind::kPowerOff:
      if (number(0) >= static_cast<uint64_t>(system_->robot_count())) Refuse("an unknown robot");
      if (self != nullptr && number(0) != static_cast<uint64_t>(self->robot))
        Refuse("the end of another robot");
      if (number(1) >= kEndKinds) Refuse("an end of an unknown kind");
      return EndRobot(kind, static_cast<int>(number(0)), {static_cast<EndKind>(number(1)), text});
    case NoteKind::kDeleteRegion:
      if (!objects_.contains(system_->regions().OwnerOf(region)))
        Refuse("the end of a region that is not its own");
      system_->regions().Delete(region);
      return;
    case NoteKind::kPin:
      ++pins_[region];
      return system_->regions().Pin(region);
    case NoteKind::kUnpin:
      return Unpin(region);
    case NoteKind::kOwner:
      if (!objects_.contains(system_->regions().OwnerOf(region)))
        Refuse("a region that is not its own");
      return system_->regions().SetOwner(region, static_cast<ObjectId>(number(1)));
    default:
      break;
  }
  // The notes below concern the current object.  While objects are loaded there is none.
  if (self == nullptr) return;
  switch (kind) {
    case NoteKind::kOpenBox:
      self->boxes.insert(number(0));
      self->last_box = std::max(self->last_box, number(0));
      return;
    case NoteKind::kCloseBox:
      self->boxes.erase(number(0));
      // A reply that has arrived meanwhile is not wanted any more.
      if (const auto reply = self->replies.find(number(0)); reply != self->replies.end()) {
        system_->queue().Release(reply->second);
        self->replies.erase(reply);
      }
      return;
    case NoteKind::kQueueMax:
      self->queue_max = static_cast<int>(number(0));
      return;
    case NoteKind::kMapBuffer:
      return MapBuffer(self, static_cast<uint32_t>(number(0)), static_cast<uint32_t>(number(1)),
                       number(2) != 0);
    case NoteKind::kEntryName:
      self->entry_names[static_cast<uint32_t>(number(0))] = text;
      return;
    default:
      Refuse(fmt::format("note {}", static_cast<uint32_t>(kind)));
  }
}

}  // namespace openr_host
