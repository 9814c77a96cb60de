#include "runtime/core/object_table.h"

#include <OPENR/ObjcommMessages.h>

#include <algorithm>
#include <utility>

#include "runtime/base/assert.h"
#include "runtime/core/api.h"
#include "runtime/core/cpu.h"
#include "runtime/core/dispatcher.h"
#include "runtime/core/object_manager.h"
#include "runtime/core/observer_state.h"
#include "runtime/core/region_access.h"
#include "runtime/core/subject_state.h"
#include "runtime/core/system.h"
#include "runtime/core/write_errors.h"

namespace openr_host {
namespace {

bool IsOf(const OServiceEntry& entry, ObjectId id) { return ObjectIdOf(entry.GetOID()) == id; }

// Gives up the regions that `observer` has received from the subjects for which `ends` returns
// true, and calls `release` with the subject's RCRegion of each region.  Needed if the object of
// the observer or of a subject is being replaced: the observer's next ready message, which would
// give the regions back, never comes then.  Keeps the regions that the observer's object still
// reads.
void ReleaseHeld(ObserverState* observer, const std::function<bool(const SubjectID&)>& ends,
                 const std::function<void(RCRegion*)>& release) {
  for (ObserverState::Held& held : observer->held) {
    if (!ends(held.subject)) continue;
    std::erase_if(held.regions, [&](RCRegion* region) {
      if (region->NumberOfReference() > 1) return false;  // the object still reads the region
      release(RegionAccess::SourceOf(region));
      RegionAccess::GiveBack(observer->system, region);
      return true;
    });
  }
}

// Ends every connection between `other` and `gone`, an object that is being replaced.  Records in
// the observers of `other` which subjects of `gone` they have lost, until they are connected with
// the new object.
void Disconnect(Object* other, Object* gone) {
  const ObjectId id = gone->id;
  const CurrentScope scope(other->system, other);
  for (const auto& subject : other->subjects()) {
    for (ObserverLink& link : subject->links) {
      if (link.target != id) continue;
      other->statistics().NoteDropped(link.units.size());
      subject->Clear(&link);
    }
    std::erase_if(subject->links, [id](const ObserverLink& link) { return link.target == id; });
    subject->infos.remove_if(
        [&](const OObserverInfo& info) { return IsOf(info.GetObserverID(), id); });
  }
  for (const auto& observer : other->observers()) {
    for (const ObserverState::Name& name : observer->names) {
      if (IsOf(name.subject, id)) observer->MissSubject(name.service);
    }
    observer->RemoveSubjects([&](const SubjectID& subject) { return IsOf(subject, id); });
    ReleaseHeld(
        observer.get(), [&](const SubjectID& subject) { return IsOf(subject, id); },
        [gone](RCRegion* region) { gone->ReturnRegion(region); });
  }
}

// Stands in the ObjectTable for an object whose robot was switched off.  An AbsentObject keeps the
// id, name and path of this object for the next boot.
class AbsentObject : public Object {
 public:
  explicit AbsentObject(const Object& gone) : Object(gone.system, gone.id, gone.robot) {
    name = gone.name;
    path = gone.path;
    set_limits(gone.limits());
    set_system(gone.is_system());
    set_absent();
    delivery().set_off(true);
  }

  // Accepts messages to all entries of the absent object.  The messages are dropped, because the
  // robot of the object is off.
  bool HasEntry(uint32_t) const override { return true; }
  bool Dispatch(uint32_t, void*) override { return false; }
};

}  // namespace

ObjectTable::~ObjectTable() {
  // Destroys the objects in reverse order, because images may refer to objects made before them.
  while (!objects_.empty()) objects_.pop_back();
}

Object* ObjectTable::Adopt(std::unique_ptr<Object> object) {
  const ObjectId id = object->id;
  if (id == NextId()) {
    objects_.push_back(std::move(object));
    return objects_.back().get();
  }
  Object* const absent = Get(id);
  ASSERT(absent != nullptr && absent->is_absent(), "id {} is in use", id);
  object->Succeed(*absent);
  objects_[static_cast<size_t>(id)] = std::move(object);
  return Get(id);
}

ObjectId ObjectTable::IdFor(int robot, std::string_view key) const {
  for (const auto& object : objects_) {
    if (object->is_absent() && object->robot == robot &&
        (object->path.empty() ? object->name : object->path) == key)
      return object->id;
  }
  return NextId();
}

Object* ObjectTable::Find(int robot, std::string_view name) const {
  for (const auto& object : objects_) {
    if (object->robot == robot && object->name == name && !object->is_absent()) return object.get();
  }
  return nullptr;
}

void ObjectTable::EndAllOf(ObjectId id) {
  for (const Listener& listener : end_listeners_) listener(id);
  std::erase_if(system_->robot(Get(id)->robot).names,
                [id](const auto& entry) { return entry.second == id; });
  system_->regions().DeleteAllOf(id);
}

void ObjectTable::RemoveAllOf(int robot) {
  std::vector<std::unique_ptr<Object>> absent;
  for (const auto& object : objects_) {
    if (object->robot != robot || object.get() == &system_->manager().host()) continue;
    absent.push_back(std::make_unique<AbsentObject>(*object));
  }
  Replace(std::move(absent));
}

void ObjectTable::DisconnectOthersFrom(ObjectId id) {
  for (const auto& other : objects_) {
    if (other != nullptr && other->id != id) Disconnect(other.get(), Get(id));
  }
}

void ObjectTable::Reload(ObjectId id) {
  ASSERT(system_->booted() && Get(id) != nullptr && Get(id)->is_image(),
         "only an image of a booted system can be reloaded");
  system_->manager().PostReload(id);
}

void ObjectTable::PostReplacement(std::vector<std::unique_ptr<Object>> fresh) {
  ASSERT(system_->booted(), "only to a booted system can an object return");
  auto kept = std::make_shared<std::vector<std::unique_ptr<Object>>>(std::move(fresh));
  system_->PostTask([this, kept] { system_->manager().ReplaceAndBoot(std::move(*kept)); });
}

// Takes and returns all messages to `object` that were not delivered yet.  They are in four places:
// held for the object, waiting for the processor, in the queue, and in outboxes.  Replies in the
// queue are released and not returned, because the handler that waits for them ends with its
// object.
std::vector<OwnedMessage> ObjectTable::TakeMessagesTo(Object* object) {
  std::vector<OwnedMessage> messages;
  while (!object->delivery().held().empty())
    messages.push_back(object->delivery().TakeNewestHeld());
  std::reverse(messages.begin(), messages.end());
  for (const auto& cpu : system_->dispatcher().cpus()) {
    for (OwnedMessage& message : cpu->TakeMessagesTo(object->id))
      messages.push_back(std::move(message));
  }
  const auto is_to_object = [object](const Message& message) {
    return message.target == object->id;
  };
  for (OwnedMessage& message : system_->queue().TakeIf(is_to_object)) {
    if (!message->is_reply) messages.push_back(std::move(message));
  }
  // The messages taken so far were counted as waiting, so subtracts their number.  The messages in
  // outboxes (of handlers whose processor time is not over), which are taken next, were never
  // counted.
  object->NoteTaken(static_cast<int>(messages.size()));
  for (const auto* const senders : {&objects_, &replaced_running_}) {
    for (const auto& sender : *senders) {
      if (sender != nullptr) sender->processor().MoveOutgoing(object->id, &messages);
    }
  }
  return messages;
}

// Removes the undelivered messages to `old`, an object that is being replaced, because `old` will
// not receive them (TakeMessagesTo()).  Returns all readies that observers have sent to `old`:
// those that `old` has received, and those among the removed messages.
std::vector<StandingReady> ObjectTable::EndMessagesTo(Object* old) {
  std::vector<StandingReady> readies = old->StandingReadies();
  for (const OwnedMessage& message : TakeMessagesTo(old)) {
    if (message->kind == PayloadKind::kReady) {
      const auto& ready = *reinterpret_cast<const OReadyMessage*>(message->payload);
      if (ready.command == objcommCMD_ASSERT_READY)
        readies.push_back({message->selector, ObjectIdOf(ready.observerID.GetOID()),
                           ready.observerID.GetSelector()});
    }
    old->HandleUndelivered(*message);
  }
  return readies;
}

// Keeps the regions of object `id` that are in undelivered notifications, so that the observers can
// still read the data.  A notification may be undelivered because the observer waits in a handler
// or for the processor, or because a gate keeps the notification.
//
// EndAllOf() deletes all regions that the object owns, so this function removes the owner of the
// kept regions (kNoObject).  The ready that later gives such a region back deletes it, if the
// object itself has kept no reference to it.
void ObjectTable::KeepSentRegions(ObjectId id) {
  RegionTable& regions = system_->regions();
  const auto keep = [&regions, id](const Message& message) {
    if (message.sender != id || message.kind != PayloadKind::kNotify) return;
    const auto& notify = *reinterpret_cast<const ONotifyMessage*>(message.payload);
    for (int i = 0; i < notify.numOfData; ++i) {
      if (regions.OwnerOf(notify.data[i].memID) == id)
        regions.SetOwner(notify.data[i].memID, kNoObject);
    }
  };
  system_->queue().ForEach(keep);
  if (const Gate* const gate = system_->dispatcher().gate()) gate->ForEach(keep);
  for (const auto& cpu : system_->dispatcher().cpus()) {
    for (const OwnedMessage& message : cpu->waiting()) keep(*message);
  }
  for (const auto& object : objects_) {
    for (const OwnedMessage& message : object->delivery().held()) keep(*message);
    for (const ProcessorState::Outgoing& outgoing : object->processor().outbox())
      keep(*outgoing.message);
  }
}

// Puts the object `fresh` in the place of the old object, which has the same id and ends.
void ObjectTable::Place(std::unique_ptr<Object> fresh) {
  const ObjectId id = fresh->id;
  Object* const old = Get(id);
  ASSERT(old != nullptr, "there is no object {} to replace", id);
  {
    const CurrentScope scope(system_, old);
    for (const auto& observer : old->observers()) {
      ReleaseHeld(
          observer.get(), [](const SubjectID&) { return true; },
          [](RCRegion* region) { region->RemoveReference(); });
    }
  }
  DisconnectOthersFrom(id);
  std::erase_if(system_->robot(old->robot).directory,
                [&](const auto& entry) { return entry.second.first == id; });
  // Ends everything that the old object still has in the System, if the old object is an image or
  // an object of a robot that was switched off.  All other objects have lost their process, and
  // EndAllOf() was called for them before PostReplacement().
  if (old->is_image() || fresh->is_absent()) {
    KeepSentRegions(id);
    EndAllOf(id);
  }
  for (const Listener& listener : replace_listeners_) listener(id);
  fresh->Succeed(*old);
  fresh->delivery().set_off(old->delivery().is_off());
  // Keeps an old object whose handler waits or still has the processor, because that handler needs
  // its object until it ends.  The memory of the robot no longer includes the heap of the old
  // object, because on the robot the object would be gone.
  if (old->running() != nullptr || old->delivery().is_busy()) {
    if (old->memory().arena() != nullptr) old->memory().arena()->LeaveBudget();
    replaced_running_.push_back(std::move(objects_[static_cast<size_t>(id)]));
  }
  objects_[static_cast<size_t>(id)] = std::move(fresh);
  if (Object* const placed = Get(id); placed->has_early_work()) RestoreEarlyWork(placed);
}

ObjectTable::Readies ObjectTable::Replace(std::vector<std::unique_ptr<Object>> fresh) {
  Readies readies;
  // Marks all objects that will be replaced (Object::is_leaving()) before EndMessagesTo() gives
  // back the regions of undelivered notifications.  If the sender of a notification is marked,
  // SendDeassert() gives the regions back by a direct call, because the sender would not receive a
  // message.
  for (const auto& object : fresh) {
    FlushStreams(Get(object->id));
    Get(object->id)->BeginReplacement();
  }
  for (const auto& object : fresh) readies[object->id] = EndMessagesTo(Get(object->id));
  for (auto& object : fresh) Place(std::move(object));
  return readies;
}

void ObjectTable::AssertAgain(ObjectId id, const std::vector<StandingReady>& readies) {
  for (const StandingReady& standing : readies) {
    const CurrentScope scope(system_, Get(standing.observer));
    OwnedMessage message = system_->NewMessage(id, standing.ready_selector);
    auto& ready = *new (message->payload) OReadyMessage;
    ready.command = objcommCMD_ASSERT_READY;
    ready.observerID = OServiceEntry(OidOf(standing.observer), standing.notify_selector);
    message->size = sizeof ready;
    message->kind = PayloadKind::kReady;
    system_->Post(std::move(message));
  }
}

}  // namespace openr_host
