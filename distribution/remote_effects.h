// RemoteEffects: applies in the master what the handlers of one worker's objects do.
//
// Effects are the messages that handlers have sent and the functions that they have called.  The
// worker sends the effects of a handler as a list, and the master applies them in this order, in
// the name of the object's stand-in (RemoteObject).  So numbers and order of messages and the trace
// are the same as in a run with one process.  A question is a call whose answer the handler waits
// for.
//
// Each effect is checked before it is applied: a worker may act only for its own objects, memory
// regions and robots.  All functions throw ProcessLost if the worker has sent what is not allowed.
#pragma once

#include <cstdint>
#include <string>

#include "distribution/call_codec.h"
#include "distribution/remote_connection.h"
#include "distribution/remote_resources.h"

namespace openr_host {

class Object;

// The reason why a handler in the worker has stopped: it has returned, or waits for a reply or a
// line of the console.
struct HandlerStop {
  openr_wire_StopKind kind = openr_wire_STOP_DONE;
  uint64_t box = 0;
  int64_t timeout_us = -1;
  uint32_t size = 0;
  std::string why;
};

class RemoteEffects {
 public:
  // Both arguments must outlive this object.
  RemoteEffects(RemoteConnection* connection, RemoteResources* resources)
      : connection_(connection), resources_(resources) {}

  // Handles a sample that a worker sends in the middle of a handler: console text, a question, or a
  // message.  Returns false if the sample is of another kind, such as the end of the handler.
  // Throws ProcessCrashed if the sample says that a handler has ended the worker.
  bool HandleRequest(const openr_wire_ToMaster& to_master);

  // Applies the effects in `to_master` in the name of `self`.  If `self` is null, no handler has
  // caused them: the worker was dropping connections, for instance.
  void Apply(const openr_wire_ToMaster& to_master, Object* self);
  // Applies the effects of the constructors of `object`, which the worker has loaded.  The messages
  // of the constructors leave the outbox of `object` now.  If the worker was restarted, they leave
  // it later, when `object` replaces the old object (EarlyWork).  `object` is null if no object was
  // loaded.  Refuses effects that only an object with connections can have.
  void ApplyLoaded(const openr_wire_ToMaster& to_master, Object* object);
  // Handles the sample that reports that a handler in the worker has stopped: applies the effects
  // of the handler, and records the data about its object.  Returns why the handler has stopped.
  HandlerStop ApplyStop(const openr_wire_ToMaster& to_master);
  // Handles the sample that reports that the worker has dropped its connections to a replaced
  // object: applies the effects, and forgets regions that the worker does not use any more.
  void ApplyForgotten(const openr_wire_ToMaster& to_master);
  // Handles the sample that reports that a subject in the worker has taken back data: applies the
  // effects, and records the data about the object of the subject.
  void ApplyTookBack(const openr_wire_ToMaster& to_master);

 private:
  void SendAnswer(const CallResult& answer);
  CallResult Call(uint32_t function, const CallArguments& arguments);
  void ApplyNote(const openr_wire_Note& note);
  int32_t Post(const openr_wire_PostedMessage& posted, Object* self);
  void CheckLoaded(const openr_wire_ToMaster& to_master) const;
  void Check(const openr_wire_Message& in, const Object* self);
  void CheckEnds(const openr_wire_Message& in, const Object* self);
  static bool Answers(const Message& message, const Object* self);

  RemoteConnection* const connection_;
  RemoteResources* const resources_;
};

}  // namespace openr_host
