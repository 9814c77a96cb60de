// RemoteProcess: the master's side of one worker process, put together from its parts.
//
// Each part has one job and uses only parts that are before it in this list:
//   RemoteConnection  sends and receives samples, finds the loss of the worker
//   RemoteResources   keeps what the worker's objects have in the master
//   RemoteEffects     checks and applies what handlers have done
//   RemoteLoader      makes the worker load its objects
//   RemoteFreeRun     handles what the worker sends in a free run
//   RemoteHandlers    runs handlers in the worker
// The functions of this class are those that need several parts.
#pragma once

#include <functional>
#include <map>
#include <string>

#include "distribution/remote_connection.h"
#include "distribution/remote_effects.h"
#include "distribution/remote_free_run.h"
#include "distribution/remote_handlers.h"
#include "distribution/remote_loader.h"
#include "distribution/remote_resources.h"
#include "runtime/core/object.h"

class RCRegion;

namespace openr_host {

class RemoteObject;

class RemoteProcess {
 public:
  // The arguments are those of RemoteConnection.
  RemoteProcess(Bus* bus, std::string name, bool is_external, std::function<std::string()> health,
                std::function<void(const std::string&)> say);

  RemoteConnection& connection() { return connection_; }
  RemoteResources& resources() { return resources_; }
  RemoteLoader& loader() { return loader_; }
  RemoteFreeRun& free_run() { return free_run_; }
  RemoteHandlers& handlers() { return handlers_; }

  const std::string& name() const { return connection_.name(); }

  // ---- Functions that the stand-ins for the worker's objects call

  bool is_lost() const { return connection_.is_lost(); }
  void ReturnRegion(RCRegion* region) { resources_.ReturnRegion(region); }
  void HandleUndelivered(const Message& message) { resources_.HandleUndelivered(message); }

  // Asks the worker for the state of `object` and returns it, for the state hash of the run.  Also
  // copies the bytes of the object's memory regions to the master, because that hash covers the
  // master's copies.  Throws ProcessLost.
  std::string FetchState(ObjectId object);

  // Makes the worker take back the data of `message`, a refused notification of `sender`
  // (Object::TakeBack()).  If the result is kPending, sets `is_ready` to whether the observer is
  // ready for the subject now.  In a free run does nothing and returns kNoSubject, because the
  // master waits for no worker.  Throws ProcessLost.
  TakenBack TakeBack(const RemoteObject* sender, const Message& message, bool* is_ready);

  // ---- Loss and restart of the worker

  // Counts the worker as lost, also in the stand-ins for its objects (Object::is_lost).  Does not
  // give back the regions of the worker.  If the run goes on, ReleaseAll() must be called instead.
  void SetLost();
  // Counts the worker as lost and releases everything that belongs to it while the run goes on.
  // Regions that were sent to the worker go back to their subjects.  Also ends the waits of all
  // handlers of stand-ins, the objects in the master that represent the worker's objects.
  void ReleaseAll();
  // Ends a restart: the worker does not count as lost any more.  `objects` are the new stand-ins in
  // the master for the worker's objects; they have replaced the old stand-ins.
  void Rejoin(const std::map<ObjectId, RemoteObject*>& objects);
  // Makes the worker drop its connections to object `id` of another process.  A new object has
  // replaced this object and will be connected again.  Throws ProcessLost.
  void Forget(ObjectId id);

  // Destroys the marshaller of the worker.  Then tells the worker to end, by
  // RemoteConnection::SendEnd() with the reason `why`, and returns the result of that function.
  // REQUIRES: the System still exists, because the marshaller uses its regions.
  bool SendEnd(const std::string& why);

 private:
  RemoteConnection connection_;
  RemoteResources resources_{&connection_};
  RemoteEffects effects_{&connection_, &resources_};
  RemoteLoader loader_{&connection_, &resources_, &effects_};
  RemoteFreeRun free_run_{&connection_, &resources_, &effects_};
  RemoteHandlers handlers_{&connection_, &resources_, &effects_, &free_run_};
};

}  // namespace openr_host
