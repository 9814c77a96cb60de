#include "runtime/core/time_events.h"

#include <algorithm>
#include <cstring>
#include <utility>

#include "runtime/base/assert.h"
#include "runtime/base/hasher.h"
#include "runtime/core/system.h"

namespace openr_host {

uint32_t TimeEvents::Add(Event event) {
  const Object* const self = t_current.object;
  if (self != nullptr && self->running() != nullptr) event.cause = self->running()->number;
  events_[++last_id_] = std::move(event);
  return last_id_;
}

uint32_t TimeEvents::AddTimed(EventMessage message, int64_t first_us, int64_t period_us) {
  Event event;
  event.message = std::move(message);
  event.due_us = system_->now_us() + first_us;
  event.period_us = period_us;
  return Add(std::move(event));
}

uint32_t TimeEvents::AddReply(EventMessage message, uint64_t box) {
  ASSERT(box != 0, "object {} waits for a reply in no box", message.owner);
  Event event;
  event.message = std::move(message);
  event.box = box;
  return Add(std::move(event));
}

bool TimeEvents::Cancel(ObjectId owner, uint32_t id) {
  const auto found = events_.find(id);
  if (found == events_.end() || found->second.message.owner != owner) return false;
  events_.erase(found);
  return true;
}

int TimeEvents::CountOf(ObjectId owner) const {
  return static_cast<int>(std::count_if(events_.begin(), events_.end(), [owner](const auto& entry) {
    return entry.second.message.owner == owner;
  }));
}

void TimeEvents::ForgetObject(ObjectId id) {
  std::erase_if(events_, [id](const auto& entry) {
    return entry.second.message.owner == id || entry.second.message.target == id;
  });
}

void TimeEvents::ForgetBox(ObjectId owner, uint64_t box) {
  std::erase_if(events_, [owner, box](const auto& entry) {
    return entry.second.message.owner == owner && entry.second.box == box;
  });
}

TimeEvents::Events TimeEvents::TakeNewerThan(uint32_t id) {
  Events taken;
  for (auto it = events_.upper_bound(id); it != events_.end(); it = events_.erase(it))
    taken.insert(std::move(*it));
  return taken;
}

TimeEvents::Events TimeEvents::TakeOf(ObjectId owner) {
  Events taken;
  for (auto it = events_.begin(); it != events_.end();) {
    const auto entry = it++;
    if (entry->second.message.owner == owner) taken.insert(events_.extract(entry));
  }
  return taken;
}

void TimeEvents::PutBack(Events events) {
  for (auto& [id, event] : events) event.due_us = std::max(event.due_us, system_->now_us());
  events_.merge(events);
}

int64_t TimeEvents::NextUs() const {
  int64_t next_us = INT64_MAX;
  for (const auto& [id, event] : events_) next_us = std::min(next_us, event.due_us);
  return next_us;
}

// Returns whether `event` (a time event or reply event) must be removed without posting its
// message, because the owner of the event or the receiver of the message no longer exists or is on
// a robot that is off.
bool TimeEvents::IsOff(const Event& event) const {
  for (const ObjectId id : {event.message.owner, event.message.target}) {
    const Object* const object = system_->object(id);
    if (object == nullptr || object->delivery().is_off()) return true;
  }
  return false;
}

void TimeEvents::Post(const Event& event) {
  const EventMessage& ordered = event.message;
  ASSERT(ordered.bytes.size() <= Message::kPayloadMax, "an event of {} bytes",
         ordered.bytes.size());
  OwnedMessage message = system_->NewMessage(ordered.target, ordered.selector);
  // Makes the owner of the event the sender of the message.  NewMessage() has set the sender to the
  // current object, but when the event is due, another object may be current, or none.
  message->sender = ordered.owner;
  message->cause = event.cause;
  if (!ordered.bytes.empty())
    std::memcpy(message->payload, ordered.bytes.data(), ordered.bytes.size());
  message->size = static_cast<uint32_t>(ordered.bytes.size());
  system_->Post(std::move(message));
}

void TimeEvents::PostDue() {
  for (auto it = events_.begin(); it != events_.end();) {
    Event& event = it->second;
    if (event.due_us > system_->now_us()) {
      ++it;
    } else if (IsOff(event)) {
      it = events_.erase(it);
    } else {
      Post(event);
      event.due_us += event.period_us;
      it = event.period_us > 0 ? std::next(it) : events_.erase(it);
    }
  }
}

void TimeEvents::ReplyArrived(ObjectId owner, uint64_t box) {
  for (auto it = events_.begin(); it != events_.end();) {
    // Compares the owner of the reply event (the object that has ordered it) too, because each
    // object numbers its reply boxes itself, so boxes of two objects may have the same number.
    if (it->second.box != box || it->second.message.owner != owner) {
      ++it;
      continue;
    }
    Post(it->second);
    it = events_.erase(it);
  }
}

void TimeEvents::HashState(Hasher* hasher) const {
  for (const auto& [id, event] : events_) {
    hasher->Add(id);
    hasher->Add(event.message.owner);
    hasher->Add(event.message.target);
    hasher->Add(event.message.selector);
    hasher->AddBytes(event.message.bytes.data(), event.message.bytes.size());
    hasher->Add(event.due_us);
    hasher->Add(event.period_us);
    hasher->Add(event.box);
  }
}

}  // namespace openr_host
