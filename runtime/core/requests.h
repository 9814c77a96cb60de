// Requests: sends requests and receives their replies.
//
// A reply arrives in a numbered box of the object that sent the request.  While a handler waits for
// the reply in a box, other objects go on.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string_view>

#include "runtime/core/message.h"

namespace openr_host {

class System;

// The right to reply to a request: the object that sent the request, and its reply box.  A ticket
// with box 0 is empty, and Requests::Reply() refuses it.
struct ReplyTicket {
  ObjectId to = kNoObject;
  uint64_t box = 0;
};

// Sends requests and replies for the current object, the caller.  An int32_t result is an sError.
class Requests {
 public:
  explicit Requests(System* system) : system_(system) {}

  // Sends a request with `size` bytes at `data`, waits for the reply, and copies at most
  // `reply_size` bytes of the reply to `reply`.  Returns sTIMEOUT if no reply came within
  // `timeout_us`.  If `timeout_us` < 0, waits without limit.
  int32_t Call(ObjectId target, uint32_t selector, const void* data, size_t size, void* reply,
               size_t reply_size, int64_t timeout_us = -1);

  // Posts the request `message` and sets `*box` to a new box for the reply.
  int32_t Send(OwnedMessage message, uint64_t* box);
  // Waits for the reply in `box`, and copies at most `reply_size` bytes of it to `reply`, if
  // `reply` is not null.  If `got` is not null, sets `*got` to the number of copied bytes.  Returns
  // sTIMEOUT if no reply came within `timeout_us`.  `why` describes for users what the handler
  // waits for: "the answer of IPStack (Send)".
  int32_t Wait(uint64_t box, void* reply, size_t reply_size, size_t* got, int64_t timeout_us,
               std::string_view why);

  // Opens a new reply box of the caller and returns its number.  Wait() and Await() close the box
  // when they have received a reply.
  uint64_t OpenBox();

  // Waits for the reply in the caller's reply box `box`, and returns the reply.  If no reply comes
  // within `timeout_us`, returns an empty message and sets `*timed_out`.  `why` describes for users
  // what the handler waits for: "the answer of IPStack (Send)".
  OwnedMessage Await(uint64_t box, int64_t timeout_us, std::string_view why, bool* timed_out);

  // Takes the right to reply to the request that the caller handles.  Returns an empty ticket if
  // the message is no request, or if its ticket was already taken, because each request gets one
  // reply.
  ReplyTicket TakeTicket();

  // Sends a reply with the `size` bytes at `data`.  If these bytes hold addresses, the caller gives
  // a `payload_hash`, which the trace then has in place of a hash of the bytes.  With a
  // `payload_hash` of 0 the bytes are hashed.
  int32_t Reply(const ReplyTicket& ticket, const void* data, size_t size,
                uint64_t payload_hash = 0);

 private:
  System* const system_;
};

// Sends the `size` bytes at `data` as the reply to the request that the current object handles, as
// Reply() of MCOOP.h does for programs.  Returns sFAIL if there is no current object,
// sEXCEEDEDSIZEOFMSG if `size` > kMessageMax, otherwise what Requests::Reply() returns.  REQUIRES:
// an ApiScope of the caller.
int32_t ReplyToRequest(const void* data, size_t size);

}  // namespace openr_host
