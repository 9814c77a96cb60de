#include "runtime/core/connection_messages.h"

#include <algorithm>
#include <new>
#include <utility>

#include "runtime/core/api.h"
#include "runtime/core/subject_state.h"
#include "runtime/core/system.h"

namespace openr_host {

void ReportForeignBytes(const Object& object) {
  object.system->AddFinding(
      Severity::kError,
      "bytes that an object sent to the entry of a subject or observer are "
      "no notification and no ready; use NotifyObservers() and AssertReady()");
}

void SendDeassert(Object* object, uint32_t selector, const SubjectID& subject,
                  const std::vector<RCRegion*>& regions) {
  System* const system = object->system;
  Object* const sender = system->object(ObjectIdOf(subject.GetOID()));
  if (sender == nullptr) return;
  // The subject's object is being replaced, so the subject receives no more messages.  Then direct
  // calls of ReturnRegion() give the regions back, not a ready.
  if (sender->is_leaving()) {
    for (RCRegion* const region : regions) sender->ReturnRegion(region);
    return;
  }
  const CurrentScope scope(system, object);
  OwnedMessage message = system->NewMessage(sender->id, subject.GetSelector());
  auto& ready = *new (message->payload) OReadyMessage;
  ready.msgType = kDeassertOfLost;
  ready.command = objcommCMD_DEASSERT_READY;
  ready.observerID = OServiceEntry(OidOf(object->id), selector);
  ready.numOfData = static_cast<int>(regions.size());
  std::copy(regions.begin(), regions.end(), ready.rcRegion);
  message->size = sizeof ready;
  message->kind = PayloadKind::kReady;
  if (system->Post(std::move(message)) == sSUCCESS) return;
  const CurrentScope there(system, sender);
  for (RCRegion* const region : regions) sender->ReturnRegion(region);
}

void RefuseNotification(Object* object, const Message& message) {
  const auto& notify = *reinterpret_cast<const ONotifyMessage*>(message.payload);
  std::vector<RCRegion*> regions;
  for (int i = 0; i < notify.numOfData; ++i) regions.push_back(notify.data[i].srcRCR);
  SendDeassert(object, message.selector, notify.subjectID, regions);
}

void HandleLateRefusal(Object* sender, const Message& message) {
  System* const system = sender->system;
  Object* const target = system->object(message.target);
  if (message.kind == PayloadKind::kReady) {
    const auto& ready = *reinterpret_cast<const OReadyMessage*>(message.payload);
    const CurrentScope scope(system, target);
    for (int i = 0; i < ready.numOfData; ++i) target->ReturnRegion(ready.rcRegion[i]);
    return;
  }
  const auto& notify = *reinterpret_cast<const ONotifyMessage*>(message.payload);
  const TakenBack result = sender->TakeBack(message);
  if (result == TakenBack::kPending) return;
  // Gives the regions back with a message: the subject has removed this observer, or its object
  // cannot be asked.
  RefuseNotification(target, message);
  // RefuseNotification() has told the subject that the observer is not ready.  The observer does
  // not know this, because it has not received the notification.  So if the subject may still be
  // connected, asserts ready again in the name of the observer.
  if (result == TakenBack::kNoSubject) {
    system->object_table().AssertAgain(
        sender->id, {{notify.subjectID.GetSelector(), target->id, message.selector}});
  }
}

}  // namespace openr_host
