// Taking an object out of a running system and putting another in its place.
#include <OPENR/ObjcommMessages.h>

#include <algorithm>
#include <utility>

#include "runtime/core/api.h"
#include "runtime/core/assert.h"
#include "runtime/core/object_manager.h"
#include "runtime/core/system.h"
#include "runtime/objcomm/state.h"

namespace openr_host {
namespace {

bool IsOf(const OServiceEntry& entry, ObjectId id) { return ObjectIdOf(entry.GetOID()) == id; }

// What `observer` still holds of subjects for which `ends` is true goes back to nobody:
// the subject's side is released here, not by a ready.
void ReleaseHeld(ObserverState* observer, const std::function<bool(const SubjectID&)>& ends,
                 bool release_source) {
  for (ObserverState::Held& held : observer->held) {
    if (!ends(held.subject)) continue;
    std::erase_if(held.regions, [&](RCRegion* region) {
      if (region->NumberOfReference() > 1) return false;  // its holder still reads it
      if (release_source) RegionAccess::SourceOf(region)->RemoveReference();
      RegionAccess::GiveBack(region);
      return true;
    });
  }
}

// Ends every connection of `other` with object `id`.
void Disconnect(Object* other, ObjectId id) {
  const CurrentScope scope(other->system, other);
  for (const auto& subject : other->subjects) {
    std::erase_if(subject->links, [&](const auto& link) {
      if (!IsOf(link->observer, id)) return false;
      subject->Clear(link.get());
      return true;
    });
    subject->infos.remove_if(
        [&](const OObserverInfo& info) { return IsOf(info.GetObserverID(), id); });
  }
  for (const auto& observer : other->observers) {
    observer->subjects.remove_if(
        [&](const OSubjectInfo& info) { return IsOf(info.GetSubjectID(), id); });
    ReleaseHeld(
        observer.get(), [&](const SubjectID& subject) { return IsOf(subject, id); }, false);
  }
}

}  // namespace

void System::Reload(ObjectId id) {
  ASSERT(booted_ && object(id) != nullptr && object(id)->is_image,
         "only an image of a booted system can be reloaded");
  manager_->PostReload(id);
}

std::vector<System::StandingReady> System::Replace(ObjectId id, std::unique_ptr<Object> fresh) {
  Object* const old = object(id);
  std::vector<StandingReady> readies;
  const auto remember = [&](uint32_t ready_selector, const ObserverID& observer) {
    readies.push_back({ready_selector, ObjectIdOf(observer.GetOID()), observer.GetSelector()});
  };
  {
    const CurrentScope scope(this, old);
    for (const auto& subject : old->subjects) {
      for (const auto& link : subject->links) {
        if (link->ready > 0) remember(subject->id.GetSelector(), link->observer);
      }
    }
    for (const auto& observer : old->observers) {
      ReleaseHeld(
          observer.get(), [](const SubjectID&) { return true; }, true);
    }
    queue_.RemoveIf(
        [&](const Message& message) { return message.target == id; },
        [&](const Message& message) {
          if (message.kind == PayloadKind::kReady) {
            const auto& ready = *reinterpret_cast<const OReadyMessage*>(message.payload);
            if (ready.command == objcommCMD_ASSERT_READY) {
              remember(message.selector, ready.observerID);
            }
          }
          if (message.kind != PayloadKind::kNotify) return;
          const auto& notify = *reinterpret_cast<const ONotifyMessage*>(message.payload);
          for (int i = 0; i < notify.numOfData; ++i) notify.data[i].srcRCR->RemoveReference();
        });
  }
  for (const auto& other : objects_) {
    if (other.get() != old) Disconnect(other.get(), id);
  }
  std::erase_if(robot(old->robot).directory,
                [&](const auto& entry) { return entry.second.first == id; });
  for (const auto& listener : unload_listeners_) listener(id);
  regions_.DeleteAllOf(id);
  fresh->message_count = old->message_count;
  objects_[static_cast<size_t>(id)] = std::move(fresh);
  return readies;
}

void System::AssertAgain(ObjectId id, const std::vector<StandingReady>& readies) {
  for (const StandingReady& standing : readies) {
    if (standing.observer == id) continue;  // its own; it asserts in DoStart
    const CurrentScope scope(this, object(standing.observer));
    Message* const message = NewMessage(id, standing.ready_selector);
    auto& ready = *new (message->payload) OReadyMessage;
    ready.msgType = omsgREADY_V22;
    ready.command = objcommCMD_ASSERT_READY;
    ready.observerID = OServiceEntry(OidOf(standing.observer), standing.notify_selector);
    ready.numOfData = 0;
    message->size = sizeof ready;
    message->kind = PayloadKind::kReady;
    Post(message);
  }
}

}  // namespace openr_host
