// The common base of TCP, UDP and DNS endpoints.
#pragma once

#include <cstdint>

#include "runtime/ipstack/network.h"
#include "runtime/ipstack/operation.h"

namespace openr_host {

class Hasher;
class IpStack;

// The owner of sockets of the Network.  It receives the events of its sockets.
class EventSink {
 public:
  virtual ~EventSink() = default;

  // Stores `event`.  Does not answer any operation yet.
  virtual void Take(const NetworkEvent& event) = 0;
};

// An endpoint of a program.  Start() stores operations, Take() stores events, and AnswerReady()
// later answers all operations that can be answered: of each endpoint first Listen or Connect, then
// Send, Receive and Close.  So the order of answers does not depend on the order of events.
class Endpoint : public EventSink {
 public:
  Endpoint(IpStack* stack, int32_t protocol, ObjectId owner, int32_t pool_bytes)
      : stack_(stack), protocol_(protocol), owner_(owner), pool_bytes_(pool_bytes) {}

  // Stores `operation`, or answers it at once with an error if it is not possible.
  virtual void Start(const Operation& operation) = 0;

  virtual void AnswerReady() = 0;

  // Returns whether an operation waits for the network, so that the stack has to poll.
  virtual bool WaitsForNetwork() const = 0;

  // Called at the beginning of each poll of the network, before Take().
  virtual void BeginFrame() {}

  // Releases all sockets without answering operations.
  virtual void Drop() = 0;

  virtual void HashState(Hasher* hasher) const = 0;

  int32_t protocol() const { return protocol_; }
  ObjectId owner() const { return owner_; }
  // true if Close was answered, so that the endpoint can be deleted
  bool dead() const { return dead_; }

 protected:
  IpStack* const stack_;
  const int32_t protocol_;  // EndpointType_...
  const ObjectId owner_;    // the object that created the endpoint
  // The pool: the largest number of bytes that are sent but not yet accepted by the network; > 0.
  const int32_t pool_bytes_;
  bool dead_ = false;
};

}  // namespace openr_host
