// Endpoint: the common base class of TCP, UDP and DNS endpoints.
#pragma once

#include <cstdint>

#include "runtime/ipstack/network.h"
#include "runtime/ipstack/operation.h"

namespace openr_host {

class Hasher;
class IpStack;

// The owner of one or more sockets of the Network: an endpoint, or a port on which endpoints
// listen.  The owner receives the events of its sockets.
class EventSink {
 public:
  virtual ~EventSink() = default;

  // Stores `event` of a socket.  Does not answer any operation of the program; AnswerReady() does
  // that after all events of one Poll() of the network have been stored.
  virtual void StoreEvent(const NetworkEvent& event) = 0;
};

// An endpoint, which a program creates for TCP, UDP or DNS.  Start() stores an operation (a message
// of the program).  StoreEvent() stores an event of the network.  AnswerReady() later answers all
// operations that can be answered, always in the same order: Listen or Connect, then Send, Receive
// and Close.  So the order of answers does not depend on the order of events.
class Endpoint : public EventSink {
 public:
  Endpoint(IpStack* stack, int32_t protocol, ObjectId owner, int32_t pool_bytes)
      : stack_(stack), protocol_(protocol), owner_(owner), pool_bytes_(pool_bytes) {}

  // Stores `operation`, a message of the program, or answers it at once with an error if it cannot
  // be executed.
  virtual void Start(const Operation& operation) = 0;

  virtual void AnswerReady() = 0;

  // Returns whether the endpoint waits for an event of the network.  While an endpoint waits, the
  // network stack polls the network every frame.
  virtual bool WaitsForNetwork() const = 0;

  // Resets the numbers that hold for one frame, such as the number of bytes that the endpoint has
  // sent in this frame.  Called at the beginning of each poll of the network, before StoreEvent().
  virtual void BeginFrame() {}

  // Releases all sockets without answering the pending operations (messages of the program).
  // Called for instance when the object that owns the endpoint has ended.
  virtual void Drop() = 0;

  virtual void HashState(Hasher* hasher) const = 0;

  int32_t protocol() const { return protocol_; }
  ObjectId owner() const { return owner_; }
  // Returns whether Close was answered, so that the endpoint can be deleted.
  bool dead() const { return dead_; }

 protected:
  IpStack* const stack_;
  const int32_t protocol_;  // protocol of the endpoint, a constant EndpointType_...
  const ObjectId owner_;    // the object that created the endpoint
  // The size of the pool in bytes, > 0.  For TCP, the pool limits the bytes that the network has
  // not accepted yet; for UDP, the bytes that were sent in this frame.  A Send that does not fit
  // into the pool waits.
  const int32_t pool_bytes_;
  bool dead_ = false;
};

}  // namespace openr_host
