// Requests of handlers and their replies.
//
// A reply arrives in a numbered box of the object that asked.  Only the handler that waits for a
// box waits: other objects go on.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string_view>

#include "runtime/core/message.h"

namespace openr_host {

class System;

// The right to answer a request: to the box of the object that asked.  An answer to an empty ticket
// is refused.
struct ReplyTicket {
  ObjectId to = kNoObject;
  uint64_t box = 0;
};

// The caller is the current object.  Results are an sError if not said otherwise.
class Requests {
 public:
  explicit Requests(System* system) : system_(system) {}

  // Sends bytes and waits for the answer, of which at most `reply_size` bytes are copied to
  // `reply`.  `timeout_us` < 0: waits for ever.
  int32_t Call(ObjectId target, uint32_t selector, const void* data, size_t size, void* reply,
               size_t reply_size, int64_t timeout_us = -1);

  // Does the same in two steps: posts `message` with a new box for its answer, and waits for it.
  // `*got`, if it is not null, becomes the number of bytes copied.
  int32_t Send(Message* message, uint64_t* box);
  int32_t Wait(uint64_t box, void* reply, size_t reply_size, size_t* got, int64_t timeout_us,
               std::string_view why);

  // Returns a new box of the caller; Wait() and Await() close it.
  uint64_t OpenBox();

  // Waits and returns the reply, which the caller releases.  When the time is over first,
  // `*timed_out` is true and the message is empty.  `why` tells people what is waited for.
  Message* Await(uint64_t box, int64_t timeout_us, std::string_view why, bool* timed_out);

  // Takes the right to answer the request that the caller handles.
  ReplyTicket TakeTicket();

  // `payload_hash` stands for the bytes in the trace; 0: the bytes are hashed.
  int32_t Reply(const ReplyTicket& ticket, const void* data, size_t size,
                uint64_t payload_hash = 0);

 private:
  System* const system_;
};

}  // namespace openr_host
