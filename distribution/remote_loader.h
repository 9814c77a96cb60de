// RemoteLoader: makes one worker load its objects.
//
// A worker that has joined gets the settings of the run, and then entries of the master's tables of
// robots and objects.  The worker loads those objects that belong to it, and sends the master a
// description of each of them.  All functions throw ProcessLost if the worker is lost.
#pragma once

#include <map>
#include <set>

#include "distribution/remote_connection.h"
#include "distribution/remote_effects.h"
#include "distribution/remote_resources.h"

namespace openr_host {

class RemoteObject;
class System;

class RemoteLoader {
 public:
  // The arguments must outlive this object.
  RemoteLoader(RemoteConnection* connection, RemoteResources* resources, RemoteEffects* effects)
      : connection_(connection), resources_(resources), effects_(effects) {}

  // Sends the worker the settings of the run, such as seed and stick.
  void Welcome(System* system, const openr_wire_Welcome& welcome);

  // Sends new entries of the master's tables of robots and objects, and waits until the worker has
  // loaded its own object, if there is one among them.
  void Load(const openr_wire_Load& load);

  // Begins to load an object of a restarted worker: sends the next entries of the master's tables
  // of robots and objects, as Load() does, but does not wait until the worker has loaded the
  // object.  The worker counts as lost until RemoteProcess::Rejoin().
  void BeginLoad(const openr_wire_Load& load);
  // Returns whether the worker has loaded the object after BeginLoad().  `objects` are the master's
  // new stand-ins for the objects of the worker.
  bool HasLoaded(const std::map<ObjectId, RemoteObject*>& objects);

 private:
  bool HandleSample(const openr_wire_ToMaster& to_master,
                    const std::map<ObjectId, RemoteObject*>& objects);

  RemoteConnection* const connection_;
  RemoteResources* const resources_;
  RemoteEffects* const effects_;
  std::set<ObjectId> awaited_objects_;  // objects that the worker is loading
};

}  // namespace openr_host
