// OObserver, the receiving end of connections.  The runtime keeps the state of each OObserver in an
// ObserverState (observer_state.h).
#include <OPENR/OObserver.h>
#include <fmt/format.h>

#include <algorithm>
#include <cstring>
#include <optional>

#include "runtime/base/assert.h"
#include "runtime/core/api.h"
#include "runtime/core/connection_messages.h"
#include "runtime/core/observer_state.h"
#include "runtime/core/region_access.h"
#include "runtime/core/requests.h"
#include "runtime/core/system.h"

using namespace openr_host;

ostream& operator<<(ostream& out, const ObserverID& id) {
  return out << fmt::format("(OID:{:#x} ,Sel:{})",
                            reinterpret_cast<uintptr_t>(id.GetOID().GetAddress()),
                            id.GetSelector());
}

OObserver::OObserver() {
  const ApiScope scope;
  ASSERT(t_current.object != nullptr, "an OObserver is made by the code of an object");
  state_ = t_current.object->AddObserver(
      std::make_unique<ObserverState>(t_current.system, t_current.object));
}

// Deletes nothing, because the openr_host::Object owns *state_ and deletes it.
OObserver::~OObserver() = default;

OStatus OObserver::SetNotifyEntry(const OServiceEntry& entry) {
  state_->id = ENTRY2OBSERVERID(entry);
  return oSUCCESS;
}

const ObserverID& OObserver::GetID() const { return state_->id; }

void OObserver::SetSkip(size_t skip) { state_->skip = skip; }

void OObserver::SetBufCtrlParam(size_t skip, size_t min, size_t max) {
  state_->skip = skip;
  state_->min = std::max<size_t>(min, 1);
  // Raises `max`, the number of notifications that may wait for a ready, to at least `min`, the
  // number that the subject collects before it sends them.  With a smaller `max` the subject would
  // drop notifications before it has collected enough, and never send any.
  state_->max = std::max(max, state_->min);
}

OStatus OObserver::AssertReady() {
  return InApi([state = state_] { return state->SendReadyToAll(objcommCMD_ASSERT_READY); });
}

OStatus OObserver::AssertReady(const SubjectID& id) {
  const ApiScope scope;
  return state_->SendReady(id, objcommCMD_ASSERT_READY);
}

OStatus OObserver::DeassertReady() {
  const ApiScope scope;
  return state_->SendReadyToAll(objcommCMD_DEASSERT_READY);
}

OStatus OObserver::DeassertReady(const SubjectID& id) {
  const ApiScope scope;
  return state_->SendReady(id, objcommCMD_DEASSERT_READY);
}

SubjectConstIterator OObserver::begin() const { return state_->subjects.begin(); }
SubjectConstIterator OObserver::end() const { return state_->subjects.end(); }
int OObserver::NumberOfSubjects() const { return static_cast<int>(state_->subjects.size()); }

SubjectID OObserver::FindSender(RCRegion* region) const {
  for (const ObserverState::Held& entry : state_->held) {
    if (std::find(entry.regions.begin(), entry.regions.end(), region) != entry.regions.end()) {
      return entry.subject;
    }
  }
  return SubjectID();
}

namespace {

// Asks the subject at `entry` to add or remove this observer, as `control` says, and waits for the
// reply.  Returns the reply; nullopt if the process of the subject is lost before the subject
// answers, because the runtime then answers with an empty message.
//
// If subject and observer belong to the same object, calls the entry of the subject directly.  The
// object could handle a message only after this handler has ended, but this handler would wait for
// the reply for ever.
std::optional<OControlReplyMessage> AskSubject(ObserverState* state, const OServiceEntry& entry,
                                               OControlMessage* control) {
  System* const system = state->system;
  OControlReplyMessage reply;
  std::memset(static_cast<void*>(&reply), 0, sizeof reply);
  // Sets the status of the reply to oFAIL first.  If the subject's entry cannot be called, this
  // status remains, and the connection counts as refused.
  reply.status = oFAIL;
  const ObjectId target = ObjectIdOf(entry.GetOID());
  if (target != state->object->id) {
    const sError error = system->requests().Call(target, entry.GetSelector(), control,
                                                 sizeof *control, &reply, sizeof reply);
    if (error == sSUCCESS && reply.msgType == 0) return std::nullopt;
    return reply;
  }
  control->command = control->command == objcommCMD_ADDOBSERVER_V22
                         ? objcommCMD_ADDOBSERVER_SELF
                         : objcommCMD_REMOVEOBSERVER_SELF;
  SelfReply self{&reply, sizeof reply, entry.GetSelector()};
  state->object->set_self_reply(&self);
  // Ends the direct call of the subject's entry in a destructor, so also if the program's function
  // for Control throws an exception.  Otherwise the object would write later replies to `self`,
  // which no longer exists then.
  struct CallEnd {
    openr_host::Object* object;
    ~CallEnd() {
      t_current.image_code = false;
      object->set_self_reply(nullptr);
    }
  };
  const CallEnd end{state->object};
  // Sets image_code, because the Control entry of the subject, which is called here, is code of the
  // object and must use the object's heap and files, not the host's.
  t_current.image_code = state->object->is_image();
  state->object->Dispatch(entry.GetSelector(), control);
  return reply;
}

}  // namespace

OStatus OObserver::ConnectHandler(const OConnectMessage& msg, OStatus status) {
  const ApiScope scope;
  const bool connect = msg.command == oconnectcmdCONNECT;
  // Stores the name of the service, by which findings name this observer.  NameService() finds the
  // service by the Connect entry that runs now, so it cannot be called later.
  state_->service = state_->object->NameService(state_->id.GetSelector(), "Notify");
  OStatusMessage answer(status);
  if (status == oSUCCESS) {
    OControlMessage control;
    // Clears the padding too, because the trace hashes all bytes of this message.
    std::memset(static_cast<void*>(&control), 0, sizeof control);
    control.msgType = omsgCONTROL_V21;
    control.command = connect ? objcommCMD_ADDOBSERVER_V22 : objcommCMD_REMOVEOBSERVER_V22;
    control.observerID = state_->id;
    control.d_skip = static_cast<longword>(state_->skip);
    control.d_min = static_cast<longword>(state_->min);
    control.d_max = static_cast<longword>(state_->max);
    std::strncpy(control.subName, state_->service.c_str(), sizeof control.subName - 1);
    const bool is_lost = msg.msgType == kConnectToLost;
    const auto reply = is_lost ? std::nullopt : AskSubject(state_, msg.entry, &control);
    answer.status = reply ? reply->status : oFAIL;
    if (!reply) {
      // The process of the subject is lost, so no reply has come.  Records the subject as missing.
      // Prints nothing, because the runtime itself reports the lost process.
      if (connect) state_->MissSubject(msg.subName);
    } else if (reply->status != oSUCCESS) {
      state_->system->Print(fmt::format(
          "ConnectHandler AddObserver refused by Subject. OStatus = {}\n", reply->status));
    } else if (connect) {
      state_->AddSubject(reply->subjectID, msg.subName);
    } else {
      state_->RemoveSubjects([&](const SubjectID& id) { return id == reply->subjectID; });
    }
  }
  ReplyToRequest(&answer, sizeof answer);
  return answer.status;
}

namespace {

// Adds an error finding if the subject has written into a region of `notify` after
// NotifyObservers().  The hash of the data then differs from the hash that was stored when the
// subject sent the data.  Called only with SystemOptions::guard_regions.
void CheckUnchanged(ObserverState* state, const ONotifyMessage& notify) {
  const Message* const message = state->object->running();
  uint32_t size = 0;
  if (message == nullptr || PayloadHash(*message, &size) == message->payload_hash) return;
  const openr_host::Object* const sender = state->system->object(message->sender);
  state->system->AddFindingAbout(
      sender, Severity::kError,
      fmt::format("{}: data were changed on their way to {}, after NotifyObservers(); a region may "
                  "be written only while NumberOfReference() is 1",
                  sender == nullptr ? "?" : sender->EntryName(notify.subjectID.GetSelector()),
                  state->object->name));
}

// Does the work of OObserver::NotifyHandler() for the observer of `state`.
[[gnu::always_inline]] inline OStatus HandleNotification(ObserverState* state,
                                                         const ONotifyMessage& msg,
                                                         ONotifyEvent* event) {
  // Refuses a message whose bytes are no notification, because this function uses some bytes of a
  // notification as addresses.
  if (!IsRunningMessage(*state->object, PayloadKind::kNotify)) return oUNKNOWN_COMMAND;
  if (state->system->options().guard_regions) CheckUnchanged(state, msg);
  // Sets the counts of repeated readies to 0.  A count tells how often the observer has asserted
  // ready to one subject without getting a notification; a large count is probably a mistake in the
  // program.  A notification from one subject resets the counts for all subjects, because
  // AssertReady() without argument asserts ready to all of them.
  for (ObserverState::Held& each : state->held) each.asserted = 0;
  // Records from which subject each region of this notification came, because the next ready to
  // that subject gives the region back.
  ObserverState::Held& held = state->HeldOf(msg.subjectID);
  const int count = msg.numOfData;
  for (int i = 0; i < count; ++i) {
    RCRegion* const region = RegionAccess::Receive(state->system, msg.data[i]);
    held.regions.push_back(region);
    event->SetData(i, region);
  }
  event->SetSubjectInfo(OSubjectInfo(msg.subjectID, objcommVERSION22));
  event->SetNumOfData(msg.numOfData);
  event->SetNumOfNotify(msg.numOfNotify);
  return oSUCCESS;
}

}  // namespace

OStatus OObserver::NotifyHandler(const ONotifyMessage& msg, ONotifyEvent* event) {
  return InApi([state = state_, &msg, event] { return HandleNotification(state, msg, event); });
}
