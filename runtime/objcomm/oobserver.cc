#include <OPENR/OObserver.h>
#include <fmt/format.h>

#include <algorithm>
#include <cstring>

#include "runtime/core/api.h"
#include "runtime/core/assert.h"
#include "runtime/core/system.h"
#include "runtime/objcomm/state.h"

using namespace openr_host;

ostream& operator<<(ostream& out, const ObserverID& id) {
  return out << fmt::format("(OID:{:#x} ,Sel:{})",
                            reinterpret_cast<uintptr_t>(id.GetOID().GetAddress()),
                            id.GetSelector());
}

OObserver::OObserver() {
  const ApiScope scope;
  ASSERT(t_current.object != nullptr, "an OObserver is made by the code of an object");
  auto& observers = t_current.object->observers;
  state_ =
      observers.emplace_back(std::make_unique<ObserverState>(t_current.system, t_current.object))
          .get();
}

OObserver::~OObserver() = default;  // the state is deleted with the object

OStatus OObserver::SetNotifyEntry(const OServiceEntry& entry) {
  state_->id = ENTRY2OBSERVERID(entry);
  return oSUCCESS;
}

const ObserverID& OObserver::GetID() const { return state_->id; }

void OObserver::SetSkip(size_t skip) { state_->skip = skip; }

void OObserver::SetBufCtrlParam(size_t skip, size_t min, size_t max) {
  state_->skip = skip;
  state_->min = std::max<size_t>(min, 1);
  state_->max = std::max(max, state_->min);
}

// Readies wait in the message queue of the subject's object; the robot refuses the 33rd message.
// So an observer that asserts again and again would fail there.
void ObserverState::CountReady(const SubjectID& subject, ObjcommCommand command) {
  constexpr int kTimesMax = 8;  // chosen: no program asserts that often on purpose
  auto entry = std::find_if(asserted.begin(), asserted.end(),
                            [&](const Asserted& each) { return each.subject == subject; });
  if (entry == asserted.end()) entry = asserted.insert(asserted.end(), {subject, 0});
  if (command != objcommCMD_ASSERT_READY) {
    entry->times = 0;
    return;
  }
  if (++entry->times != kTimesMax + 1 || object->is_system) return;
  const openr_host::Object* const peer = system->object(ObjectIdOf(subject.GetOID()));
  system->AddFindingAbout(
      object, Severity::kWarning,
      fmt::format("{}: asserts ready to {} again and again ({} times) without a notification "
                  "between; ready is a flag, once per notification is enough",
                  service, peer == nullptr ? "an unknown object" : peer->name, entry->times));
}

OStatus ObserverState::SendReady(const SubjectID& subject, ObjcommCommand command) {
  Message* const message = system->NewMessage(ObjectIdOf(subject.GetOID()), subject.GetSelector());
  auto& ready = *new (message->payload) OReadyMessage;
  ready.command = command;
  ready.observerID = id;
  message->size = sizeof ready;
  message->kind = PayloadKind::kReady;
  // Regions without a reference in this object go back.  Those that do not fit into this ready wait
  // for the next one.
  RCRegion* returned[MAX_NUM_DATA];
  std::vector<RCRegion*>* regions = nullptr;
  for (Held& entry : held) {
    if (entry.subject == subject) regions = &entry.regions;
  }
  if (regions != nullptr) {
    for (RCRegion* region : *regions) {
      if (region->NumberOfReference() > 1 || ready.numOfData == MAX_NUM_DATA) continue;
      returned[ready.numOfData] = region;
      ready.rcRegion[ready.numOfData++] = RegionAccess::SourceOf(region);
    }
  }
  const int count = ready.numOfData;
  // Posted first: if the message is refused, this object keeps the regions.
  const sError error = system->Post(message);
  if (error != sSUCCESS) {
    system->Print(fmt::format("OObserver({})::SendReady() Sending Ready failed. sError = {}\n",
                              service, error));
    return oSEND_FAIL;
  }
  CountReady(subject, command);
  for (int i = 0; i < count; ++i) {
    std::erase(*regions, returned[i]);
    RegionAccess::GiveBack(returned[i]);
  }
  return oSUCCESS;
}

void openr_host::SendDeassert(openr_host::Object* object, uint32_t selector,
                              const SubjectID& subject, const std::vector<RCRegion*>& regions) {
  System* const system = object->system;
  openr_host::Object* const sender = system->object(ObjectIdOf(subject.GetOID()));
  if (sender == nullptr) return;
  // An object that is being replaced receives no more messages, so it gets its regions directly.
  if (sender->is_leaving) {
    for (RCRegion* const region : regions) sender->TakeBack(region);
    return;
  }
  const CurrentScope scope(system, object);
  Message* const message = system->NewMessage(sender->id, subject.GetSelector());
  auto& ready = *new (message->payload) OReadyMessage;
  ready.msgType = kDeassertOfLost;
  ready.command = objcommCMD_DEASSERT_READY;
  ready.observerID = OServiceEntry(OidOf(object->id), selector);
  ready.numOfData = static_cast<int>(regions.size());
  std::copy(regions.begin(), regions.end(), ready.rcRegion);
  message->size = sizeof ready;
  message->kind = PayloadKind::kReady;
  if (system->Post(message) == sSUCCESS) return;
  const CurrentScope there(system, sender);
  const bool is_here = !sender->subjects.empty();  // the regions of a stand-in belong to a worker
  for (RCRegion* const region : regions) {
    if (is_here) {
      region->RemoveReference();
    } else {
      sender->TakeBack(region);
    }
  }
}

void openr_host::RefuseNotification(openr_host::Object* object, const Message& message) {
  const auto& notify = *reinterpret_cast<const ONotifyMessage*>(message.payload);
  std::vector<RCRegion*> regions;
  for (int i = 0; i < notify.numOfData; ++i) regions.push_back(notify.data[i].srcRCR);
  SendDeassert(object, message.selector, notify.subjectID, regions);
}

OStatus OObserver::AssertReady() {
  const ApiScope scope;
  OStatus status = oSUCCESS;
  for (const OSubjectInfo& subject : state_->subjects) {
    const OStatus one = state_->SendReady(subject.GetSubjectID(), objcommCMD_ASSERT_READY);
    if (one != oSUCCESS) status = one;
  }
  return status;
}

OStatus OObserver::AssertReady(const SubjectID& id) {
  const ApiScope scope;
  return state_->SendReady(id, objcommCMD_ASSERT_READY);
}

OStatus OObserver::DeassertReady() {
  const ApiScope scope;
  OStatus status = oSUCCESS;
  for (const OSubjectInfo& subject : state_->subjects) {
    const OStatus one = state_->SendReady(subject.GetSubjectID(), objcommCMD_DEASSERT_READY);
    if (one != oSUCCESS) status = one;
  }
  return status;
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

// Asks the subject at `entry` to add or remove this observer.  A subject of the same object is
// called directly: a message would wait until this handler ends.
OControlReplyMessage AskSubject(ObserverState* state, const OServiceEntry& entry,
                                OControlMessage* control) {
  System* const system = state->system;
  OControlReplyMessage reply;
  std::memset(static_cast<void*>(&reply), 0, sizeof reply);
  reply.status = oFAIL;
  const ObjectId target = ObjectIdOf(entry.GetOID());
  if (target != state->object->id) {
    system->Call(target, entry.GetSelector(), control, sizeof *control, &reply, sizeof reply);
    return reply;
  }
  control->command = control->command == objcommCMD_ADDOBSERVER_V22
                         ? objcommCMD_ADDOBSERVER_SELF
                         : objcommCMD_REMOVEOBSERVER_SELF;
  openr_host::Object::SelfReply self{&reply, sizeof reply, entry.GetSelector()};
  state->object->self_reply = &self;
  // The entry is code of the object again, as when the dispatcher calls it.
  t_current.image_code = state->object->is_image;
  state->object->Dispatch(entry.GetSelector(), control);
  t_current.image_code = false;
  state->object->self_reply = nullptr;
  return reply;
}

}  // namespace

OStatus OObserver::ConnectHandler(const OConnectMessage& msg, OStatus status) {
  const ApiScope scope;
  const bool connect = msg.command == oconnectcmdCONNECT;
  state_->service = state_->object->NameService(state_->id.GetSelector(), "Notify");
  OStatusMessage answer(status);
  if (status == oSUCCESS) {
    OControlMessage control;
    std::memset(static_cast<void*>(&control), 0, sizeof control);
    control.msgType = omsgCONTROL_V21;
    control.command = connect ? objcommCMD_ADDOBSERVER_V22 : objcommCMD_REMOVEOBSERVER_V22;
    control.observerID = state_->id;
    control.d_skip = static_cast<longword>(state_->skip);
    control.d_min = static_cast<longword>(state_->min);
    control.d_max = static_cast<longword>(state_->max);
    std::strncpy(control.subName, state_->service.c_str(), sizeof control.subName - 1);
    const OControlReplyMessage reply = AskSubject(state_, msg.entry, &control);
    answer.status = reply.status;
    if (reply.status != oSUCCESS) {
      state_->system->Print(fmt::format(
          "ConnectHandler AddObserver refused by Subject. OStatus = {}\n", reply.status));
    } else if (connect) {
      state_->subjects.push_back(OSubjectInfo(reply.subjectID, objcommVERSION22));
    } else {
      state_->subjects.remove_if(
          [&](const OSubjectInfo& info) { return info.GetSubjectID() == reply.subjectID; });
    }
  }
  Reply(&answer, sizeof answer);
  return answer.status;
}

namespace {

// Adds a finding if the data differ from those that were sent (SystemOptions::guard_regions).
void CheckUnchanged(ObserverState* state, const ONotifyMessage& notify) {
  const Message* const message = state->object->running;
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

}  // namespace

OStatus OObserver::NotifyHandler(const ONotifyMessage& msg, ONotifyEvent* event) {
  const ApiScope scope;
  if (!IsRunningMessage(*state_->object, PayloadKind::kNotify)) return oUNKNOWN_COMMAND;
  if (state_->system->options().guard_regions) CheckUnchanged(state_, msg);
  // See ObserverState::Asserted.
  state_->asserted.clear();
  auto entry = std::find_if(state_->held.begin(), state_->held.end(),
                            [&](const auto& each) { return each.subject == msg.subjectID; });
  if (entry == state_->held.end()) {
    entry = state_->held.insert(state_->held.end(), {msg.subjectID, {}});
  }
  for (int i = 0; i < msg.numOfData; ++i) {
    RCRegion* const region = RegionAccess::Receive(msg.data[i].srcRCR, msg.data[i].memID,
                                                   msg.data[i].offset, msg.data[i].size);
    entry->regions.push_back(region);
    event->SetData(i, region);
  }
  event->SetSubjectInfo(OSubjectInfo(msg.subjectID, objcommVERSION22));
  event->SetNumOfData(msg.numOfData);
  event->SetNumOfNotify(msg.numOfNotify);
  return oSUCCESS;
}
