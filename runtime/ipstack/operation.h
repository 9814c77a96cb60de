// An operation: a message of a program that the network stack has not answered yet.
#pragma once

#include <antEnvMsg.h>

#include <cstdint>

#include "runtime/core/message.h"
#include "runtime/core/requests.h"

namespace openr_host {

struct Operation {
  alignas(16) unsigned char bytes[Message::kPayloadMax] = {};  // the message struct, then zeros
  uint32_t size = 0;                                           // size of the message struct
  ObjectId sender = kNoObject;
  uint64_t request_hash = 0;  // AntMessageHash() of the request, including its data
  uint64_t cause = 0;         // number of the message whose handler sent the request; 0 at boot
  ReplyTicket ticket;         // needed to answer a Call(); empty for a Send()

  antEnvMsg& message() { return *reinterpret_cast<antEnvMsg*>(bytes); }
  const antEnvMsg& message() const { return *reinterpret_cast<const antEnvMsg*>(bytes); }

  // Returns the message of this operation as the type T, such as TCPEndpointSendMsg.  REQUIRES: T
  // is the type that belongs to the protocol and the field dstOperation of the message.
  template <typename T>
  T& As() {
    static_assert(sizeof(T) <= sizeof bytes);
    return static_cast<T&>(message());
  }
};

}  // namespace openr_host
