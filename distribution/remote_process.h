// RemoteProcess: the master's side of one worker process.
//
// The worker runs one handler at a time, until the handler returns or waits.  It sends the effects
// of the handler back as a list, and the master applies them in this order, in the name of the
// object's stand-in (RemoteObject).  So numbers and order of messages and the trace are the same as
// in a run with one process.
#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "distribution/latency.h"
#include "distribution/remote_connection.h"
#include "distribution/remote_effects.h"
#include "distribution/remote_resources.h"

class RCRegion;

namespace openr_host {

class Object;
class RemoteObject;
class System;

class RemoteProcess {
 public:
  // `is_external` is true if a user starts the worker.  `health` returns the problem of the worker
  // process, or "".  `say` prints a line for the user.
  RemoteProcess(Bus* bus, std::string name, bool is_external, std::function<std::string()> health,
                std::function<void(const std::string&)> say);

  RemoteConnection& connection() { return connection_; }
  RemoteResources& resources() { return resources_; }
  const std::string& name() const { return connection_.name(); }
  bool is_lost() const { return connection_.is_lost(); }

  // ---- All functions from here on may throw ProcessLost, except where noted.

  // Sends the worker the settings of the run, such as seed and stick.
  void Welcome(System* system, const openr_wire_Welcome& welcome);

  // Sends new entries of the master's tables of robots and objects, and waits until the worker has
  // loaded its own objects among them.
  void Load(const openr_wire_Load& load);

  // Begins to load the objects of a restarted worker: sends new entries of the master's tables of
  // robots and objects, as Load() does, but does not wait.  The worker counts as lost until
  // Rejoin().
  void BeginLoad(const openr_wire_Load& load);
  // Returns whether the worker has loaded its objects after BeginLoad().  `objects` are the
  // master's new stand-ins for these objects.
  bool HasLoaded(const std::map<ObjectId, RemoteObject*>& objects);
  // Ends a restart: the worker does not count as lost any more.  `objects` are the new stand-ins in
  // the master for the worker's objects; they have replaced the old stand-ins.
  void Rejoin(const std::map<ObjectId, RemoteObject*>& objects);

  // Makes the worker drop its connections to object `id` of another process.  A new object has
  // replaced this object and will be connected again.
  void Forget(ObjectId id);

  // Switches to free running: while a handler of an object runs in the worker, only this object
  // gets no further message; the master goes on with the messages to other objects.
  // HandleReceived() applies the effects of the handler when they arrive.
  void RunFree() { is_free_ = true; }

  // Returns whether, in a free run, a handler of the object runs in the worker at this time.  A
  // handler that waits for a reply does not count.
  bool IsAtWork(ObjectId object) const { return running_.contains(object); }

  // Returns the number of messages that are lost with the worker in a free run, in which the master
  // sends several messages to the worker without waiting.  Notifications and ready messages are not
  // counted, because their data go back to the senders.  The message whose handler crashed the
  // worker is not counted either.
  size_t CountUndelivered() const;

  // Handles the samples that the worker has sent; returns true if the worker had sent samples.
  // Must not be called from a handler.  If the worker is lost, sets loss() and does not throw.
  bool HandleReceived();
  // Checks that the worker still exists.  If the worker is lost, sets loss() and does not throw.
  void CheckHealth();

  // Returns the durations from sending a message to the worker until the master knows that the
  // message's handler is done.
  const Latency& latency() const { return latency_; }
  Latency LatencyOf(ObjectId object) const {
    const auto found = latency_of_.find(object);
    return found == latency_of_.end() ? Latency() : found->second;
  }

  // Runs the handler of `message`, which is being delivered to `object`.  Returns false if the
  // worker was lost before the handler ended.
  bool RunHandler(RemoteObject* object, const Message& message);

  // Asks the worker for the state of `object` and returns it, for the state hash of the run.  Also
  // copies the bytes of the object's memory regions to the master, because that hash covers the
  // master's copies.
  std::string FetchState(ObjectId object);

  // Releases everything that belongs to the lost worker while the run goes on.  Regions that were
  // sent to the worker go back to their subjects.  Also ends the waits of all handlers of
  // stand-ins, the objects in the master that represent the worker's objects.
  void ReleaseAll();

  // Returns the reason of a loss of the worker that HandleReceived() or CheckHealth() has found; ""
  // if they have found no loss.
  const std::string& loss() const { return loss_; }
  // Returns whether a handler has ended the worker, for instance by a crash.
  bool has_crashed() const { return crashed_; }
  // Returns the object of the handler that has ended the worker; kNoObject if it is not known.
  ObjectId crashed_object() const { return crashed_object_; }

  // Releases a memory region that the worker sent, and sends no ready message for it.  To be called
  // when the object that sent the region was lost or replaced, because then no subject waits for
  // the region.
  void ReturnRegion(RCRegion* region) { resources_.ReturnRegion(region); }
  // Handles a message that the lost worker did not receive.  If `message` is a ready message,
  // releases the regions that it gives back.  Messages of other kinds are ignored.
  void HandleUndelivered(const Message& message) { resources_.HandleUndelivered(message); }

  // Ends the worker and tells it `why` the run has ended: the text of DescribeEnd(), or "".
  // REQUIRES: the System still exists.
  void End(const std::string& why);

 private:
  bool WillSendMore() const;
  void ReportSilence();
  std::optional<HandlerStop> WaitForStop(RemoteObject* object);
  std::optional<HandlerStop> WaitForStopInFreeRun(RemoteObject* object);
  void HandleFreeSample(const openr_wire_ToMaster& to_master);
  bool HandleLoaded(const openr_wire_ToMaster& to_master,
                    const std::map<ObjectId, RemoteObject*>& objects);
  template <typename Action>
  void RecordLoss(const Action& action);
  void ResumeWithReply(RemoteObject* object, const HandlerStop& stop, uint64_t session);
  void ResumeWithLine(RemoteObject* object, const HandlerStop& stop, uint64_t session);

  RemoteConnection connection_;
  RemoteResources resources_{&connection_};
  RemoteEffects effects_{&connection_, &resources_};
  const std::string wait_reason_;       // tells the user what a RemoteObject waits for
  std::set<ObjectId> awaited_objects_;  // objects that the worker is loading
  Latency latency_;
  std::map<ObjectId, Latency> latency_of_;
  // ---- Free runs
  //
  // While a handler runs in the worker, the object's stand-in waits in the master for a reply.
  // HandleFreeSample() posts this reply when the handler has stopped.
  bool is_free_ = false;
  uint64_t wake_box_count_ = 0;  // number of reply boxes made for RemoteObjects
  // The objects of which a handler runs in the worker now; the value is the reply box for which the
  // object's stand-in waits in the master.
  std::map<ObjectId, uint64_t> running_;
  std::map<ObjectId, HandlerStop> stops_;  // the reason why the handler of each object has stopped
  // The time of the worker's last sample, or the time when an idle worker was given work.
  // ReportSilence() compares it with the present time.
  int64_t last_heard_ms_ = 0;
  bool is_silent_ = false;  // whether the user was told that the worker is silent
  std::string loss_;        // reason of the loss of the worker, or ""
  bool crashed_ = false;
  ObjectId crashed_object_ = kNoObject;
};

}  // namespace openr_host
