// Replacement of an object of a running System; see Reload() and Return() in system.h.
#include <OPENR/ObjcommMessages.h>

#include <algorithm>
#include <utility>

#include "runtime/base/assert.h"
#include "runtime/core/api.h"
#include "runtime/core/connection_state.h"
#include "runtime/core/object_manager.h"
#include "runtime/core/system.h"

namespace openr_host {
namespace {

bool IsOf(const OServiceEntry& entry, ObjectId id) { return ObjectIdOf(entry.GetOID()) == id; }

// Gives up the regions that `observer` has received from the subjects for which `ends` is true.
// The regions cannot go back with a ready, because either the observer's or the subject's object is
// being replaced.  So `release` is called with the subject's region.
void ReleaseHeld(ObserverState* observer, const std::function<bool(const SubjectID&)>& ends,
                 const std::function<void(RCRegion*)>& release) {
  for (ObserverState::Held& held : observer->held) {
    if (!ends(held.subject)) continue;
    std::erase_if(held.regions, [&](RCRegion* region) {
      if (region->NumberOfReference() > 1) return false;  // the object still reads the region
      release(RegionAccess::SourceOf(region));
      RegionAccess::GiveBack(region);
      return true;
    });
  }
}

// Ends every connection of `other` with `gone`.
void Disconnect(Object* other, Object* gone) {
  const ObjectId id = gone->id;
  const CurrentScope scope(other->system, other);
  for (const auto& subject : other->subjects) {
    std::erase_if(subject->links, [&](const auto& link) {
      if (!IsOf(link->observer, id)) return false;
      other->dropped_count += link->units.size();
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
        observer.get(), [&](const SubjectID& subject) { return IsOf(subject, id); },
        [gone](RCRegion* region) { gone->ReturnRegion(region); });
  }
}

}  // namespace

void System::Reload(ObjectId id) {
  ASSERT(booted_ && object(id) != nullptr && object(id)->is_image,
         "only an image of a booted system can be reloaded");
  manager_->PostReload(id);
}

void System::Return(std::vector<std::unique_ptr<Object>> fresh) {
  ASSERT(booted_, "only to a booted system can an object return");
  auto kept = std::make_shared<std::vector<std::unique_ptr<Object>>>(std::move(fresh));
  PostTask([this, kept] { manager_->Begin(std::move(*kept)); });
}

void System::PostTask(std::function<void()> task) { manager_->PostTask(std::move(task)); }

void System::EndAllOf(ObjectId id) {
  for (const auto& listener : end_listeners_) listener(id);
  std::erase_if(robot(object(id)->robot).names,
                [id](const auto& entry) { return entry.second == id; });
  regions_.DeleteAllOf(id);
}

void System::Forget(ObjectId id) {
  for (const auto& other : objects_) {
    if (other != nullptr && other->id != id) Disconnect(other.get(), object(id));
  }
}

std::vector<StandingReady> Object::StandingReadies() const {
  std::vector<StandingReady> readies;
  for (const auto& subject : subjects) {
    for (const auto& link : subject->links) {
      if (link->ready > 0)
        readies.push_back({subject->id.GetSelector(), ObjectIdOf(link->observer.GetOID()),
                           link->observer.GetSelector()});
    }
  }
  return readies;
}

// Takes and returns all messages to `object`: messages that are held, that wait for the processor,
// that are due now or later, and those in outboxes of objects whose handler's time is not over.
// Replies in the queue are released, because the handler that waits for them ends.
std::vector<OwnedMessage> System::TakeMessagesTo(Object* object) {
  std::vector<OwnedMessage> messages;
  for (OwnedMessage& message : object->handler.held) messages.push_back(std::move(message));
  object->handler.held.clear();
  for (const auto& cpu : cpus_) {
    for (OwnedMessage& message : cpu->TakeMessagesTo(object->id))
      messages.push_back(std::move(message));
  }
  const auto is_to_object = [object](const Message& message) {
    return message.target == object->id;
  };
  for (OwnedMessage& message : queue_.TakeIf(is_to_object)) {
    if (!message->is_reply) messages.push_back(std::move(message));
  }
  // This subtraction comes before the outboxes are searched, because messages in an outbox do not
  // count as waiting.
  object->waiting -= static_cast<int>(messages.size());
  ASSERT(object->waiting >= 0, "{} has {} waiting messages", object->name, object->waiting);
  const auto take_outgoing = [&](const std::unique_ptr<Object>& sender) {
    if (sender == nullptr) return;
    for (ProcessorState::Outgoing& outgoing : sender->processor.outbox) {
      if (outgoing.message->target == object->id && !outgoing.message->is_reply)
        messages.push_back(std::move(outgoing.message));
    }
    std::erase_if(sender->processor.outbox, [](const ProcessorState::Outgoing& outgoing) {
      return outgoing.message == nullptr;
    });
  };
  for (const auto& sender : objects_) take_outgoing(sender);
  for (const auto& sender : outlived_) take_outgoing(sender);
  return messages;
}

void Object::HandleUndelivered(const Message& message) {
  if (message.kind != PayloadKind::kReady) ++dropped_count;
  if (message.kind == PayloadKind::kNotify) RefuseNotification(this, message);
}

std::vector<StandingReady> System::EndMessagesTo(Object* old) {
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

void System::Replace(std::unique_ptr<Object> fresh) {
  const ObjectId id = fresh->id;
  Object* const old = object(id);
  ASSERT(old != nullptr, "there is no object {} to replace", id);
  {
    const CurrentScope scope(this, old);
    for (const auto& observer : old->observers) {
      ReleaseHeld(
          observer.get(), [](const SubjectID&) { return true; },
          [](RCRegion* region) { region->RemoveReference(); });
    }
  }
  Forget(id);
  std::erase_if(robot(old->robot).directory,
                [&](const auto& entry) { return entry.second.first == id; });
  if (old->is_image) EndAllOf(id);
  for (const auto& listener : replace_listeners_) listener(id);
  fresh->message_count = old->message_count;
  fresh->dropped_count = old->dropped_count;
  fresh->is_off = old->is_off;
  fresh->waiting = old->waiting;  // messages that a gate keeps will reach `fresh`
  // A handler that waits, or that still has the processor, ends later and needs its object until
  // then.
  if (old->handler.running != nullptr || old->processor.is_busy)
    outlived_.push_back(std::move(objects_[static_cast<size_t>(id)]));
  objects_[static_cast<size_t>(id)] = std::move(fresh);
}

void System::AssertAgain(ObjectId id, const std::vector<StandingReady>& readies) {
  for (const StandingReady& standing : readies) {
    const CurrentScope scope(this, object(standing.observer));
    OwnedMessage message = NewMessage(id, standing.ready_selector);
    auto& ready = *new (message->payload) OReadyMessage;
    ready.command = objcommCMD_ASSERT_READY;
    ready.observerID = OServiceEntry(OidOf(standing.observer), standing.notify_selector);
    message->size = sizeof ready;
    message->kind = PayloadKind::kReady;
    Post(std::move(message));
  }
}

}  // namespace openr_host
