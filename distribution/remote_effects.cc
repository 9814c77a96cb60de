#include "distribution/remote_effects.h"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <utility>

#include "distribution/remote_object.h"
#include "distribution/worker_call_list.h"
#include "runtime/core/api.h"
#include "runtime/core/cpu.h"
#include "runtime/core/system.h"

namespace openr_host {
namespace {

// The longest delay or timeout in microseconds that a worker may ask for.  Programs give times as
// RelativeTime, with 32 bits for seconds and 32 bits for milliseconds, and the longest RelativeTime
// is shorter than this limit.  So a time above the limit is an error of the worker and is refused.
constexpr int64_t kDelayMaxUs = int64_t{1} << 53;

// Gives WorkerCallList::Call() the C++ object on which it is to call a function.  Call() calls
// operator() with a null pointer to the class of the function, and the type of this pointer selects
// one of the overloads below.  For RobotServices, the C++ object is the services of the current
// object's robot.  For the other classes, it is the CheckedCalls, which check the call of the
// worker.
struct CallTargets {
  System* system;
  CheckedCalls* calls;

  SystemCalls* operator()(SystemCalls*) const { return calls; }
  CheckedCalls* operator()(CheckedCalls*) const { return calls; }
  RobotServices* operator()(RobotServices*) const {
    return system->robot(t_current.object->robot).services.get();
  }
};

// Keeps the messages of `object` in its outbox while this OutboxScope exists.  So a message that is
// refused later is handled as in a run with one process (cpu.h).  After that, the messages leave
// the outbox.  They stay only if the object is to replace the object of a lost worker (EarlyWork).
class OutboxScope {
 public:
  explicit OutboxScope(Object* object) : object_(object) { object_->delivery().set_busy(true); }
  ~OutboxScope() { object_->delivery().set_busy(object_->has_early_work()); }
  OutboxScope(const OutboxScope&) = delete;
  OutboxScope& operator=(const OutboxScope&) = delete;

 private:
  Object* const object_;
};

// Returns whether a worker may call function number `function` while no handler runs and there is
// no current object.  Workers call the functions of kFunctions also when they drop connections.
// Calls of all other functions without a current object are ignored.
bool MayLackCaller(uint32_t function) {
  constexpr uint32_t kFunctions[] = {
      WorkerCallList::NumberOf<&SystemCalls::DeleteRegion>(),
      WorkerCallList::NumberOf<&SystemCalls::PinRegion>(),
      WorkerCallList::NumberOf<&SystemCalls::UnpinRegion>(),
      WorkerCallList::NumberOf<&SystemCalls::Shutdown>(),
      WorkerCallList::NumberOf<&SystemCalls::PowerOff>(),
      WorkerCallList::NumberOf<&CheckedCalls::AddFindingAbout>(),
  };
  return std::find(std::begin(kFunctions), std::end(kFunctions), function) != std::end(kFunctions);
}

}  // namespace

bool RemoteEffects::HandleRequest(const openr_wire_ToMaster& to_master) {
  switch (to_master.body._d) {
    case openr_wire_TO_MASTER_CONSOLE:
      resources_->system()->Print(StringOf(to_master.body._u.console_text));
      return true;
    case openr_wire_TO_MASTER_QUESTION: {
      const openr_wire_Question& in = to_master.body._u.question;
      Object* const self = resources_->ObjectOf(in.object);
      // Applies the messages and calls that the handler has made before its question, because the
      // answer may depend on them.
      Apply(to_master, self);
      const CurrentScope scope(resources_->system(), self);
      SendAnswer(Call(in.kind, {VectorOf(in.numbers), StringOf(in.text), StringOf(in.bytes)}));
      return true;
    }
    case openr_wire_TO_MASTER_ENTRY: {
      const Object* const object = resources_->system()->object(to_master.body._u.entry.object);
      const bool has = object != nullptr && object->HasEntry(to_master.body._u.entry.selector);
      SendAnswer({has ? 1 : 0});
      return true;
    }
    case openr_wire_TO_MASTER_POST: {
      Object* const self = resources_->ObjectOf(to_master.body._u.post.object);
      Apply(to_master, self);
      SendAnswer({Post(to_master.body._u.post.posted, self)});
      return true;
    }
    case openr_wire_TO_MASTER_CRASHED: {
      const openr_wire_Crashed& crashed = to_master.body._u.crashed;
      throw ProcessCrashed(StringOf(crashed.text), crashed.object);
    }
    case openr_wire_TO_MASTER_STOPPED:
      if (to_master.body._u.stopped.timeout_us > kDelayMaxUs)
        connection_->Refuse("a wait until another time");
      return false;
    default:
      return false;
  }
}

void RemoteEffects::SendAnswer(const CallResult& answer) {
  WireArena arena;
  openr_wire_ToWorker to_worker = NewToWorker(openr_wire_TO_WORKER_ANSWER);
  to_worker.body._u.answer = {answer.status, arena.Numbers(answer.numbers),
                              WireArena::View(answer.bytes.data(), answer.bytes.size())};
  connection_->Send(to_worker);
}

void RemoteEffects::Apply(const openr_wire_ToMaster& to_master, Object* self) {
  const CurrentScope scope(resources_->system(), self);
  for (uint32_t i = 0; i < to_master.effects._length; ++i) {
    const openr_wire_Effect& effect = to_master.effects._buffer[i];
    if (effect._d == openr_wire_EFFECT_POST) {
      Post(effect._u.posted, self);
    } else {
      const openr_wire_Note& note = effect._u.note;
      ApplyNote(note);
    }
  }
}

// Refuses a notification and a ready in the effects of constructors.  Constructors have no
// connections, so only a faulty worker sends them.  A refused notification would make PostOutbox()
// wait for the worker, which could be lost during this wait, while the caller still reads
// `to_master`.
void RemoteEffects::CheckLoaded(const openr_wire_ToMaster& to_master) const {
  for (uint32_t i = 0; i < to_master.effects._length; ++i) {
    const openr_wire_Effect& effect = to_master.effects._buffer[i];
    if (effect._d != openr_wire_EFFECT_POST) continue;
    const openr_wire_PayloadKind kind = effect._u.posted.message.payload._d;
    if (kind == openr_wire_PAYLOAD_NOTIFY || kind == openr_wire_PAYLOAD_READY)
      connection_->Refuse("a notification or a ready of a constructor");
  }
}

void RemoteEffects::ApplyLoaded(const openr_wire_ToMaster& to_master, Object* object) {
  CheckLoaded(to_master);
  if (object == nullptr) return Apply(to_master, nullptr);
  {
    const OutboxScope scope(object);
    Apply(to_master, object);
  }
  if (object->has_early_work()) return;
  const CurrentScope scope(resources_->system(), object);
  PostOutbox(object);
}

HandlerStop RemoteEffects::ApplyStop(const openr_wire_ToMaster& to_master) {
  const openr_wire_Stopped& stopped = to_master.body._u.stopped;
  RemoteObject* const object = resources_->ObjectOf(stopped.object);
  Apply(to_master, object);
  object->statistics().set_state(StringOf(stopped.state));
  resources_->RecordDropped(object, stopped.dropped);
  object->statistics().set_stack_max(stopped.stack_max);
  object->heap_max = stopped.heap_max;
  resources_->RecordHeap(object->robot, stopped.heap_here);
  object->pending_count = stopped.pending;
  return {stopped.kind, stopped.box, stopped.timeout_us, stopped.size, StringOf(stopped.why)};
}

void RemoteEffects::ApplyForgotten(const openr_wire_ToMaster& to_master) {
  Apply(to_master, nullptr);
  resources_->marshaller()->PeerDropped(VectorOf(to_master.body._u.forgotten.dropped));
}

void RemoteEffects::ApplyTookBack(const openr_wire_ToMaster& to_master) {
  const openr_wire_TookBack& took_back = to_master.body._u.took_back;
  RemoteObject* const object = resources_->ObjectOf(took_back.object);
  Apply(to_master, object);
  resources_->RecordDropped(object, took_back.dropped);
  object->pending_count = took_back.pending;
}

// Returns whether `message` answers the request that the handler of `self` is serving, or forwards
// that request to another object.  In both cases the object owes no answer any more.
bool RemoteEffects::Answers(const Message& message, const Object* self) {
  const Message* const request = self == nullptr ? nullptr : self->running();
  return request != nullptr && message.reply_box != 0 && message.reply_box == request->reply_box &&
         (message.is_reply ? message.target : message.sender) == request->sender;
}

// Refuses a message if its sender, or the object of its subject or observer, is not `self`.  If
// `self` is null, accepts any object of this worker in place of `self`.  If the handler of `self`
// forwards a request, accepts the sender of this request, because a forwarded request keeps its
// sender.
void RemoteEffects::CheckEnds(const openr_wire_Message& in, const Object* self) {
  const auto is_own = [&](ObjectId id) {
    return self == nullptr ? id == kNoObject || resources_->objects().contains(id) : id == self->id;
  };
  const Message* const request = self == nullptr ? nullptr : self->running();
  const bool is_forwarded = request != nullptr && !in.is_reply && in.reply_box != 0 &&
                            in.reply_box == request->reply_box && in.sender == request->sender;
  if (!is_own(in.sender) && !is_forwarded)
    connection_->Refuse("a message in the name of another object");
  // Accepts an id that no object has.  Such an id is sent by a subject or an observer for which the
  // program has set no entry (SetReadyEntry(), SetNotifyEntry()).
  const auto belongs_to_other = [&](ObjectId id) {
    return !is_own(id) && resources_->system()->object(id) != nullptr;
  };
  if (in.payload._d == openr_wire_PAYLOAD_NOTIFY && belongs_to_other(in.payload._u.notify.subject))
    connection_->Refuse("a notification of another object's subject");
  if (in.payload._d == openr_wire_PAYLOAD_READY && belongs_to_other(in.payload._u.ready.observer))
    connection_->Refuse("a ready of another object's observer");
}

void RemoteEffects::Check(const openr_wire_Message& in, const Object* self) {
  CheckEnds(in, self);
  const auto check_region = [this](uint32_t region) {
    if (resources_->system()->regions().BaseOf(region) != nullptr && !resources_->MayUse(region))
      connection_->Refuse(fmt::format("bytes of region {:#x}, which it has not", region));
  };
  if (in.payload._d == openr_wire_PAYLOAD_ANT) check_region(in.payload._u.ant.region);
  if (in.payload._d != openr_wire_PAYLOAD_NOTIFY) return;
  const auto& parts = in.payload._u.notify.parts;
  for (uint32_t i = 0; i < parts._length; ++i) check_region(parts._buffer[i].region);
}

int32_t RemoteEffects::Post(const openr_wire_PostedMessage& posted, Object* self) {
  Check(posted.message, self);
  const CurrentScope scope(resources_->system(), self);
  OwnedMessage message =
      resources_->system()->NewMessage(posted.message.target, posted.message.selector);
  // Saves the message's class and cause, which NewMessage() has set, because Decode() may replace
  // members of the message by the worker's values.  The class decides the order of messages that
  // are due at the same time.  The cause is the number of the message whose handler sends this
  // message.
  const MessageClass message_class = message->message_class;
  const uint64_t cause = message->cause;
  const std::string problem = resources_->marshaller()->Decode(posted.message, message.get());
  resources_->marshaller()->ReleaseSample();
  if (!problem.empty()) connection_->Refuse(problem);
  if (posted.delay_us < 0 || posted.delay_us > kDelayMaxUs)
    connection_->Refuse("a message for another time");
  // Restores the message's class and cause (the number of the message whose handler sends this
  // message), so that they are the same as in a run with one process.  Removes the number that the
  // worker has given to the message, because System::Post() gives it a number of the master.
  message->number = 0;
  message->cause = cause;
  message->message_class = message_class;
  if (message->is_reply) {
    // Refuses a reply if the object that asked has closed its reply box meanwhile.  A run with one
    // process refuses such a reply, too.
    const Object* const asker = resources_->system()->object(message->target);
    if (asker == nullptr || !asker->boxes().IsOpen(message->reply_box)) return sRBOXWASCLEANED;
  }
  const bool is_notify = message->kind == PayloadKind::kNotify && self != nullptr;
  const StandingReady used = {is_notify ? posted.message.payload._u.notify.selector : 0,
                              message->target, message->selector};
  const bool answers = Answers(*message, self);
  const int32_t error = resources_->system()->Post(std::move(message), posted.delay_us);
  if (error != sSUCCESS) resources_->marshaller()->UndoDecode();
  // Marks the request, to which this message is the reply, as answered.  Without this mark the
  // master would answer the request again if the worker is lost before the handler ends
  // (RemoteObject::SendEmptyReply()).
  if (answers && error == sSUCCESS) self->running()->reply_box = 0;
  // Records that the observer is not ready any more.  After a notification, an observer must assert
  // ready again before it gets the next notification.
  if (is_notify && error == sSUCCESS) resources_->objects().at(self->id)->UseReady(used);
  return error;
}

// Calls function number `function` of WorkerCallList (the list of the master's functions that
// workers may call), as a worker has asked, in the name of the current object.  There is no current
// object if no handler has caused the call.  For a number that is not in the list, returns the
// status oNOT_SUPPORTED.
CallResult RemoteEffects::Call(uint32_t function, const CallArguments& arguments) {
  if (function >= WorkerCallList::kSize) return {oNOT_SUPPORTED};
  return WorkerCallList::Call(function, CallTargets{resources_->system(), resources_->calls()},
                              arguments);
}

void RemoteEffects::ApplyNote(const openr_wire_Note& note) {
  if (note.kind >= WorkerCallList::kSize) connection_->Refuse(fmt::format("note {}", note.kind));
  if (t_current.object == nullptr && !MayLackCaller(note.kind)) return;
  Call(note.kind, {VectorOf(note.numbers), StringOf(note.text)});
}

}  // namespace openr_host
