// RemoteHandlers: runs handlers in one worker, and measures how long they take.
//
// The worker runs one handler at a time, until the handler returns or waits.  In lockstep the
// master waits until then.  In a free run the master goes on, and RemoteFreeRun handles what the
// worker sends.  A handler that waits for a reply or a line of the console is resumed when the
// master has this reply or line.
#pragma once

#include <cstdint>
#include <map>
#include <optional>

#include "distribution/latency.h"
#include "distribution/remote_connection.h"
#include "distribution/remote_effects.h"
#include "distribution/remote_free_run.h"
#include "distribution/remote_resources.h"

namespace openr_host {

class RemoteObject;

class RemoteHandlers {
 public:
  // The arguments must outlive this object.
  RemoteHandlers(RemoteConnection* connection, RemoteResources* resources, RemoteEffects* effects,
                 RemoteFreeRun* free_run)
      : connection_(connection), resources_(resources), effects_(effects), free_run_(free_run) {}

  // Switches to free running: while a handler of an object runs in the worker, only this object
  // gets no further message; the master goes on with the messages to other objects.
  void RunFree() { is_free_ = true; }
  bool is_free() const { return is_free_; }

  // Runs the handler of `message`, which is being delivered to `object`.  Returns false if the
  // loss of the worker was noticed elsewhere while the handler waited.  Throws ProcessLost if this
  // function itself notices the loss.
  bool Run(RemoteObject* object, const Message& message);

  // Returns the durations from sending a message to the worker until the master knows that the
  // message's handler is done.
  const Latency& latency() const { return latency_; }
  Latency LatencyOf(ObjectId object) const;

 private:
  void Deliver(RemoteObject* object, const Message& message);
  bool WillSendMore() const;
  std::optional<HandlerStop> WaitForStop(RemoteObject* object);
  void ResumeWithReply(RemoteObject* object, const HandlerStop& stop, uint64_t session);
  void ResumeWithLine(RemoteObject* object, const HandlerStop& stop, uint64_t session);

  RemoteConnection* const connection_;
  RemoteResources* const resources_;
  RemoteEffects* const effects_;
  RemoteFreeRun* const free_run_;
  bool is_free_ = false;
  Latency latency_;
  std::map<ObjectId, Latency> latency_of_;
};

}  // namespace openr_host
