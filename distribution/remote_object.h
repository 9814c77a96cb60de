// RemoteObject: the master's stand-in for an object whose code runs in a worker.
#pragma once

#include <OPENR/ObjcommTypes.h>

#include <cstdint>
#include <functional>
#include <memory>
#include <set>
#include <string>
#include <vector>

#include "distribution/wire.h"
#include "runtime/core/object.h"

class RCRegion;

namespace openr_host {

class RemoteProcess;

class RemoteObject : public Object {
 public:
  // The ways in which a worker can be lost.  kGone means that the worker has ended or cannot be
  // reached.  kCrashed means that a handler has crashed.  kAtEnd means that the worker was lost
  // after the run, when the master asked only for the state of its objects.
  enum class Loss { kGone, kCrashed, kAtEnd };
  // A function that is called when a RemoteObject finds that its worker is lost.  `why` is a text
  // for the user.
  using LossListener = std::function<void(const RemoteObject*, Loss, const std::string& why)>;

  RemoteObject(System* system, ObjectId id, int robot, RemoteProcess* process, LossListener lost)
      : Object(system, id, robot), process_(process), lost_(std::move(lost)) {}

  RemoteProcess* process() const { return process_; }
  void set_selectors(std::set<uint32_t> selectors) { selectors_ = std::move(selectors); }
  // Stores what the worker reports about the object after it has loaded the object: its priority,
  // its memory sizes, and its entries with their names.
  void SetDescription(const openr_wire_LoadedObject& loaded);

  // Number of messages that came for the object after its worker was lost.  No handler ran for
  // these messages.
  uint64_t undelivered_count = 0;
  // Number of notifications that waited in the object's subjects when its last handler ended,
  // because their observers were not ready.  These notifications are lost with the worker; the
  // report tells their number.
  uint64_t pending_count = 0;
  uint64_t heap_max = 0;  // the most bytes of heap that the object has used

  // Makes the RemoteObject that replaces this RemoteObject when the worker is restarted.
  std::unique_ptr<RemoteObject> NewInstance() const;

  // Records that a subject of this object has notified an observer.  `ready` was the observer's
  // assert.  From now on this observer is not ready until it asserts ready again.
  void UseReady(const StandingReady& ready) { readies_.erase(ready); }

  // Forgets the ready events that came from the object `observer`, because that object has been
  // replaced.
  void ForgetObserver(ObjectId observer);

  std::vector<StandingReady> StandingReadies() const override;
  void ReturnRegion(RCRegion* region) override;
  TakenBack TakeBack(const Message& message) override;
  // Counts `message`, which came after the worker was lost.  If it is a ready message, releases the
  // regions that it gives back.  If it is a notification, gives its regions back to the subject.
  // If its sender waits for a reply, sends an empty reply.
  void HandleUndelivered(const Message& message) override;
  bool HasEntry(uint32_t selector) const override { return selectors_.contains(selector); }
  bool Dispatch(uint32_t selector, void* payload) override;
  void HashState(Hasher* hasher) const override;

 private:
  bool Run();
  void RecordReady();
  void SendEmptyReply(const Message& request);

  RemoteProcess* const process_;
  const LossListener lost_;
  std::set<uint32_t> selectors_;
  // Observers that have asserted ready to a subject of this object and were not notified since
  // then.  The worker knows these asserts too, but loses them when it ends, so a restarted worker
  // gets them again from this set.
  std::set<StandingReady> readies_;
};

}  // namespace openr_host
