// RemoteResources: what the objects of one worker have in the master.
//
// These are the stand-ins of the objects, the regions that master and worker have exchanged, pins
// of regions, and heap.  When the worker is lost, ReleaseAll() gives back regions, pins and heap,
// because the worker cannot do so any more.
#pragma once

#include <cstdint>
#include <map>
#include <memory>

#include "distribution/checked_calls.h"
#include "distribution/marshaller.h"
#include "distribution/remote_connection.h"
#include "runtime/core/message.h"

class RCRegion;

namespace openr_host {

class RemoteObject;
class System;

class RemoteResources {
 public:
  // `connection` must outlive this object.
  explicit RemoteResources(RemoteConnection* connection) : connection_(connection) {}
  RemoteResources(const RemoteResources&) = delete;
  RemoteResources& operator=(const RemoteResources&) = delete;

  // Makes the marshaller and the CheckedCalls for a worker that joins the run of `system`.  For a
  // restarted worker, keeps those that exist already.
  void Begin(System* system);
  // Destroys the marshaller.  REQUIRES: the System still exists, because the memory of received
  // regions is in the System's region table.
  void End() { marshaller_.reset(); }

  // ---- The results of the next three functions are null before Begin().
  System* system() const { return system_; }
  Marshaller* marshaller() const { return marshaller_.get(); }
  // Returns the CheckedCalls, which check and then do what handlers in the worker ask the master.
  CheckedCalls* calls() const { return calls_.get(); }

  // Returns the master's stand-ins for the worker's objects.
  const std::map<ObjectId, RemoteObject*>& objects() const { return objects_; }
  // Adds the stand-in for an object that the worker will load.
  void Add(RemoteObject* object);
  // Sets the new stand-ins of a restarted worker, which have replaced the old ones.
  void Replace(const std::map<ObjectId, RemoteObject*>& objects) { objects_ = objects; }
  // Records in the stand-ins whether the worker is lost (Object::is_lost).
  void SetLost(bool is_lost) const;
  // Returns the stand-in for object `id`, which the worker has named in a sample.  Throws
  // ProcessLost if this object is not an object of the worker.
  RemoteObject* ObjectOf(ObjectId id) const;

  // Returns whether the worker may send bytes for the memory region `region`.  The worker may do so
  // if an object of the worker owns or has made the region, or if the region was sent to the
  // worker.
  bool MayUse(uint32_t region) const;

  // Returns the bytes of heap used on `robot` by all objects but those of this worker.  The worker
  // needs this number to know how much of the robot's memory is left, because all objects of a
  // robot share its memory.  May be called before Begin().
  uint64_t HeapOfOtherProcesses(System* system, int robot) const;
  // Records the bytes of heap that the worker's objects use on `robot`.  Throws ProcessLost if the
  // number is too large.
  void RecordHeap(int robot, uint64_t bytes);
  // Records how many data and messages of `object` were lost (Object::dropped_count).  `count` is
  // the number that the worker has counted since its start.
  void RecordDropped(RemoteObject* object, uint64_t count);

  // Releases a memory region that the worker sent, and sends no ready message for it.  To be called
  // when the object that sent the region was lost or replaced, because then no subject waits for
  // the region.
  void ReturnRegion(RCRegion* region) { marshaller_->ReleaseImported(region); }
  // Handles a message that the lost worker did not receive.  If `message` is a ready message,
  // releases the regions that it gives back.  Messages of other kinds are ignored.
  void HandleUndelivered(const Message& message);

  // Ends the wait of a stand-in: posts the reply to `box`, for which the stand-in waits.
  void Wake(ObjectId object, uint64_t box);
  // Releases everything that belongs to the lost worker while the run goes on.  Regions that were
  // sent to the worker go back to their subjects.  Also ends the waits of all handlers of
  // stand-ins.
  void ReleaseAll();

 private:
  void ReleaseExported();

  RemoteConnection* const connection_;
  System* system_ = nullptr;
  std::unique_ptr<Marshaller> marshaller_;
  std::unique_ptr<CheckedCalls> calls_;
  std::map<ObjectId, RemoteObject*> objects_;
  // For each object of the worker, the number of lost data and messages (Object::dropped_count)
  // that the worker has reported last.  The master adds only the increase to its own count.
  std::map<ObjectId, uint64_t> dropped_;
  // For each robot, the number of heap bytes that the worker's objects use.
  std::map<int, uint64_t> heap_by_robot_;
};

}  // namespace openr_host
