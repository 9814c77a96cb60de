// Time events and reply events: messages that objects have ordered for a certain time, with a
// period, or for the arrival of a reply (SetTimeEvent() and SetReplyEvent() of MCOOP.h).
#pragma once

#include <cstdint>
#include <map>
#include <vector>

#include "runtime/core/message.h"

namespace openr_host {

class Hasher;
class System;

class TimeEvents {
 public:
  explicit TimeEvents(System* system) : system_(system) {}

  // The message that a time event or a reply event posts: receiver, entry and at most
  // Message::kPayloadMax bytes.
  struct EventMessage {
    ObjectId owner = kNoObject;  // the object that has ordered the event and may cancel it
    ObjectId target = kNoObject;
    uint32_t selector = 0;
    std::vector<unsigned char> bytes;
  };

  // A time event or a reply event.
  struct Event {
    EventMessage message;
    int64_t due_us = INT64_MAX;  // INT64_MAX if the event waits for a reply
    int64_t period_us = 0;
    uint64_t box = 0;    // box in which the event waits for a reply; 0 for a time event
    uint64_t cause = 0;  // number of the message whose handler has ordered the event
  };
  using Events = std::map<uint32_t, Event>;  // the key is the id of the event

  // Adds a time event, which posts `message` after `first_us` and then every `period_us`, or only
  // once if the period is 0.  Returns the id of the event, which is at least 1.
  uint32_t AddTimed(EventMessage message, int64_t first_us, int64_t period_us);
  // Adds a reply event, which posts `message` once, when the reply to a request of the owner has
  // arrived in the owner's reply box `box`.  REQUIRES: box != 0.
  uint32_t AddReply(EventMessage message, uint64_t box);

  // Cancels the time event or reply event `id`.  Returns false if `owner` has no such event.
  bool Cancel(ObjectId owner, uint32_t id);
  // Removes the reply events of object `owner` that wait for the reply in its reply box `box`,
  // because the box is closed and no reply will arrive.
  void ForgetBox(ObjectId owner, uint64_t box);
  // Returns the number of time events and reply events of `owner`.
  int CountOf(ObjectId owner) const;
  // Removes all time events and reply events of object `id`, and all such events that post to it,
  // because the object has ended or is being replaced.
  void ForgetObject(ObjectId id);

  // Returns the id of the newest event; 0 if no event was added yet.
  uint32_t last_id() const { return last_id_; }
  // Takes away the events that were added after the event `id`, and returns them.  They post
  // nothing until PutBack().
  Events TakeNewerThan(uint32_t id);
  // Takes away the events that `owner` has ordered, as TakeNewerThan() does, and returns them.
  Events TakeOf(ObjectId owner);
  // Puts back `events`, which TakeNewerThan() or TakeOf() has returned.  Time events whose due time
  // has passed meanwhile are due now.
  void PutBack(Events events);

  // Returns the virtual time at which the next time event is due; INT64_MAX if there is no time
  // event.
  int64_t NextUs() const;
  // Posts the messages of all time events that are due now, in the order of the events' ids, which
  // is the same in every run.
  void PostDue();
  // Posts the messages of the reply events of object `owner` that wait for the reply in its reply
  // box `box`, and removes these events.  Called when this reply has arrived.
  void ReplyArrived(ObjectId owner, uint64_t box);

  void HashState(Hasher* hasher) const;

 private:
  uint32_t Add(Event event);
  void Post(const Event& event);
  bool IsOff(const Event& event) const;

  System* const system_;
  Events events_;
  uint32_t last_id_ = 0;
};

}  // namespace openr_host
