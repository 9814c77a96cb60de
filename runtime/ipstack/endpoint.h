// What TCP, UDP and DNS endpoints have in common.
#pragma once

#include <cstdint>

#include "runtime/ipstack/network.h"
#include "runtime/ipstack/operation.h"

namespace openr_host {

class Hasher;
class IpStack;

// Something that owns sockets of the Network and hears of them.
class EventSink {
 public:
  virtual ~EventSink() = default;

  // Notes what happened; answers nothing yet.
  virtual void Take(const NetworkEvent& event) = 0;
};

// One endpoint.  Operations come in with Start(), events with Take(); both leave what
// can be answered to AnswerReady(), so that answers go out in a defined order: by
// endpoint, then open, send, receive, close.
class Endpoint : public EventSink {
 public:
  Endpoint(IpStack* stack, int32_t protocol, ObjectId owner, int32_t pool_bytes)
      : stack_(stack), protocol_(protocol), owner_(owner), pool_bytes_(pool_bytes) {}

  // Takes a message, or answers it when it cannot be.
  virtual void Start(const Operation& operation) = 0;

  virtual void AnswerReady() = 0;

  // Whether something is due from the network, so that it has to be polled.
  virtual bool WaitsForNetwork() const = 0;

  // A poll begins.
  virtual void BeginFrame() {}

  // Gives up all sockets; answers nothing.
  virtual void Drop() = 0;

  virtual void HashState(Hasher* hasher) const = 0;

  int32_t protocol() const { return protocol_; }
  ObjectId owner() const { return owner_; }
  bool dead() const { return dead_; }  // its Close has been answered

 protected:
  IpStack* const stack_;
  const int32_t protocol_;    // EndpointType_...
  const ObjectId owner_;      // who created it
  const int32_t pool_bytes_;  // most bytes sent and not yet taken by the network; > 0
  bool dead_ = false;
};

}  // namespace openr_host
