// Messages that objects have asked for: at a time, every so often, or when a reply is there
// (SetTimeEvent and SetReplyEvent of MCOOP.h).
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

  // Where a message goes and its bytes, at most Message::kPayloadMax.
  struct Letter {
    ObjectId owner = kNoObject;  // who asked, and who may cancel
    ObjectId target = kNoObject;
    uint32_t selector = 0;
    std::vector<unsigned char> bytes;
  };

  // First after `first_us`, then every `period_us`; period 0: once.  Returns its id, from 1.
  uint32_t AddTimed(Letter letter, int64_t first_us, int64_t period_us);
  // Once, when the reply to `box` of the owner is there to be received.
  uint32_t AddReply(Letter letter, uint64_t box);

  // False when `owner` has no event `id`.
  bool Cancel(ObjectId owner, uint32_t id);
  int CountOf(ObjectId owner) const;
  void ForgetObject(ObjectId id);

  // When the next one is due; INT64_MAX when there is none.
  int64_t NextUs() const;
  // Posts those that are due now, in the order in which they were asked for.
  void PostDue();
  void ReplyArrived(ObjectId owner, uint64_t box);

  void HashState(Hasher* hasher) const;

 private:
  struct Event {
    Letter letter;
    int64_t due_us = INT64_MAX;  // never: waits for a reply
    int64_t period_us = 0;
    uint64_t box = 0;
    uint64_t cause = 0;  // number of the message in whose handler it was asked for
  };

  uint32_t Add(Event event);
  void Post(const Event& event);
  bool IsOff(const Event& event) const;

  System* const system_;
  std::map<uint32_t, Event> events_;  // by id
  uint32_t last_id_ = 0;
};

}  // namespace openr_host
