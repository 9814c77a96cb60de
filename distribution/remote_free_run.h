// RemoteFreeRun: the handlers that run in one worker in a free run, in which the master does not
// wait for handlers.
//
// While the handler of an object runs in the worker, the object's stand-in waits in the master for
// a reply.  So only this object gets no further message.  HandleReceived() applies the effects of
// the handler when they arrive, and posts the reply when the handler has stopped.
//
// No function waits for the worker's next sample.  HandleReceived() handles the samples that have
// arrived, and CheckHealth() finds the loss of the worker.  So both must be called often, between
// the messages of the run.
#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <string>

#include "distribution/remote_connection.h"
#include "distribution/remote_effects.h"
#include "distribution/remote_resources.h"

namespace openr_host {

class RemoteObject;

class RemoteFreeRun {
 public:
  // The arguments must outlive this object.
  RemoteFreeRun(RemoteConnection* connection, RemoteResources* resources, RemoteEffects* effects);

  // Waits until the handler of `object` in the worker has stopped.  Only `object` waits: other
  // objects run meanwhile.  Returns nullopt if the worker was lost.
  std::optional<HandlerStop> WaitForStop(RemoteObject* object);

  // Returns how many messages are lost if the worker ends now: messages that the master has sent
  // and that the worker has not handled completely.  Four kinds of messages do not count.  The data
  // of a notification return to its subject.  The effect of a ready message is stored in the
  // master. DoInit to DoDestroy are no messages of a program.  The message whose handler has
  // crashed the worker is reported as a crash.
  size_t CountUndelivered() const;

  // Handles the samples that the worker has sent; returns true if the worker had sent samples.
  // Must not be called from a handler.  If the worker is lost, sets loss() and does not throw.
  bool HandleReceived();
  // Checks that the worker still exists.  If the worker is lost, sets loss() and does not throw.
  void CheckHealth();

  // The loss of a worker.
  struct Loss {
    std::string why;           // the reason, "" if the worker is not lost
    bool has_crashed = false;  // whether a handler has ended the worker, for instance by a crash
    ObjectId crashed_object = kNoObject;  // object whose handler has ended the worker, or kNoObject
  };
  // Returns the loss of the worker that HandleReceived() or CheckHealth() has found.
  const Loss& loss() const { return loss_; }

  // Forgets all handlers, because the worker is lost.  Their stand-ins are woken by
  // RemoteResources::ReleaseAll().
  void ForgetHandlers();
  // Forgets the loss, because another process has taken the place of the worker.
  void ForgetLoss() { loss_ = {}; }

 private:
  void HandleSample(const openr_wire_ToMaster& to_master);
  void ReportSilence();
  template <typename Action>
  void RecordLoss(const Action& action);

  RemoteConnection* const connection_;
  RemoteResources* const resources_;
  RemoteEffects* const effects_;
  const std::string wait_reason_;  // tells the user what a stand-in waits for
  uint64_t wake_box_count_ = 0;    // number of reply boxes made for stand-ins
  // The objects of which a handler runs in the worker now; the value is the reply box for which the
  // object's stand-in waits in the master.
  std::map<ObjectId, uint64_t> running_;
  std::map<ObjectId, HandlerStop> stops_;  // the reason why the handler of each object has stopped
  // The time of the worker's last sample, or the time when an idle worker was given work.
  // ReportSilence() compares it with the present time.
  int64_t last_heard_ms_ = 0;
  bool is_silent_ = false;  // whether the user was told that the worker is silent
  Loss loss_;
};

}  // namespace openr_host
