// A message to the stack that has not been answered yet.
#pragma once

#include <antEnvMsg.h>

#include <cstdint>

#include "runtime/core/message.h"
#include "runtime/core/system.h"

namespace openr_host {

struct Operation {
  alignas(16) unsigned char bytes[Message::kPayloadMax] = {};  // the struct, then zeros
  uint32_t size = 0;                                           // of the struct
  ObjectId sender = kNoObject;
  uint64_t request_hash = 0;  // AntMessageHash() of the request, including its data
  ReplyTicket ticket;         // of a Call(); empty for a Send()

  antEnvMsg& message() { return *reinterpret_cast<antEnvMsg*>(bytes); }
  const antEnvMsg& message() const { return *reinterpret_cast<const antEnvMsg*>(bytes); }

  // REQUIRES: T is the type that the operation code stands for.
  template <typename T>
  T& As() {
    static_assert(sizeof(T) <= sizeof bytes);
    return static_cast<T&>(message());
  }
};

}  // namespace openr_host
