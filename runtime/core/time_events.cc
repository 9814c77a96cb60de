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
  if (self != nullptr && self->handler.running != nullptr)
    event.cause = self->handler.running->number;
  events_[++last_id_] = std::move(event);
  return last_id_;
}

uint32_t TimeEvents::AddTimed(Letter letter, int64_t first_us, int64_t period_us) {
  Event event;
  event.letter = std::move(letter);
  event.due_us = system_->now_us() + first_us;
  event.period_us = period_us;
  return Add(std::move(event));
}

uint32_t TimeEvents::AddReply(Letter letter, uint64_t box) {
  Event event;
  event.letter = std::move(letter);
  event.box = box;
  return Add(std::move(event));
}

bool TimeEvents::Cancel(ObjectId owner, uint32_t id) {
  const auto found = events_.find(id);
  if (found == events_.end() || found->second.letter.owner != owner) return false;
  events_.erase(found);
  return true;
}

int TimeEvents::CountOf(ObjectId owner) const {
  return static_cast<int>(std::count_if(events_.begin(), events_.end(), [owner](const auto& entry) {
    return entry.second.letter.owner == owner;
  }));
}

void TimeEvents::ForgetObject(ObjectId id) {
  std::erase_if(events_, [id](const auto& entry) {
    return entry.second.letter.owner == id || entry.second.letter.target == id;
  });
}

void TimeEvents::ForgetBox(ObjectId owner, uint64_t box) {
  std::erase_if(events_, [owner, box](const auto& entry) {
    return entry.second.letter.owner == owner && entry.second.box == box;
  });
}

TimeEvents::Events TimeEvents::TakeNewerThan(uint32_t id) {
  Events taken;
  for (auto it = events_.upper_bound(id); it != events_.end(); it = events_.erase(it))
    taken.insert(std::move(*it));
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

// Returns whether the owner of `event` (a time event or reply event), or the object that it posts
// to, no longer exists, or is on a robot that is off.  Such an event is removed and posts nothing.
bool TimeEvents::IsOff(const Event& event) const {
  for (const ObjectId id : {event.letter.owner, event.letter.target}) {
    const Object* const object = system_->object(id);
    if (object == nullptr || object->delivery.is_off()) return true;
  }
  return false;
}

void TimeEvents::Post(const Event& event) {
  const Letter& letter = event.letter;
  ASSERT(letter.bytes.size() <= Message::kPayloadMax, "an event of {} bytes", letter.bytes.size());
  OwnedMessage message = system_->NewMessage(letter.target, letter.selector);
  // Posts the message in the name of the object that owns the event.  NewMessage() has set the
  // sender to the current object.  When the event is due, the current object may be another object
  // than the owner, or there may be no current object.
  message->sender = letter.owner;
  message->cause = event.cause;
  if (!letter.bytes.empty())
    std::memcpy(message->payload, letter.bytes.data(), letter.bytes.size());
  message->size = static_cast<uint32_t>(letter.bytes.size());
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
    if (it->second.box != box || it->second.letter.owner != owner) {
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
    hasher->Add(event.letter.owner);
    hasher->Add(event.letter.target);
    hasher->Add(event.letter.selector);
    hasher->AddBytes(event.letter.bytes.data(), event.letter.bytes.size());
    hasher->Add(event.due_us);
    hasher->Add(event.period_us);
    hasher->Add(event.box);
  }
}

}  // namespace openr_host
