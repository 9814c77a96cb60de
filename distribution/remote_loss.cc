// The part of RemoteProcess that releases regions, messages and connections when a worker was lost,
// or when an object of another process was replaced.
#include <algorithm>
#include <utility>
#include <vector>

#include "distribution/remote_object.h"
#include "distribution/remote_process.h"
#include "runtime/core/api.h"
#include "runtime/core/connection_state.h"
#include "runtime/core/system.h"

namespace openr_host {

// Gives the regions that were sent to the lost worker back to the subjects that sent them.  The
// worker's observers cannot do this any more.  So the master sends deasserts ("not ready"), which
// give the regions back, in the name of these observers.
void RemoteProcess::ReturnExported() {
  using Entry = std::pair<ObjectId, uint32_t>;
  // The regions to give back, grouped by observer and subject.  A deassert ("not ready") goes from
  // one observer to one subject, so the regions of one group go back with one deassert.
  std::map<std::pair<Entry, Entry>, std::vector<RCRegion*>> regions;
  for (const Marshaller::ExportedRegion& exported : marshaller_->TakeExported())
    regions[{{exported.observer, exported.observer_selector},
             {exported.subject, exported.subject_selector}}]
        .push_back(exported.region);
  for (const auto& [ends, exported] : regions) {
    const auto& [observer, subject] = ends;
    const auto found = objects_.find(observer.first);
    if (found == objects_.end()) continue;
    // Sends several deasserts if necessary, because one deassert gives back MAX_NUM_DATA regions at
    // most.
    for (size_t i = 0; i < exported.size(); i += MAX_NUM_DATA) {
      const auto begin = exported.begin() + static_cast<ptrdiff_t>(i);
      const auto count = std::min<ptrdiff_t>(MAX_NUM_DATA, exported.end() - begin);
      SendDeassert(found->second, observer.second,
                   OServiceEntry(OidOf(subject.first), subject.second), {begin, begin + count});
    }
  }
}

size_t RemoteProcess::CountUndelivered() const {
  size_t count = 0;
  for (const auto& [id, box] : running_) {
    const Message& message = *objects_.at(id)->handler.running;
    const bool is_bytes =
        message.kind != PayloadKind::kNotify && message.kind != PayloadKind::kReady;
    if (id != crashed_object_ && is_bytes && message.selector > oentryDESTROY) ++count;
  }
  return count;
}

void RemoteProcess::ReleaseAll() {
  // Counts the worker as lost first.  The calls below post messages to the master's stand-ins for
  // the worker's objects, and the stand-ins must not send these messages to the worker.
  connection_.set_lost();
  ReturnExported();
  marshaller_->PeerIsLost();
  for (const auto& [id, object] : objects_) {
    // Ends the wait of a RemoteObject, the master's stand-in for an object of the worker, if its
    // handler in the worker had not returned.  The lost worker will never report the end of this
    // handler.
    if (object->delivery.blocked() != nullptr) WakeHandler(id, object->wait.box);
  }
  calls_->ReleasePins();
  // Removes the lost process's counts of dropped notifications and its heap use, because the next
  // process counts from 0.
  dropped_.clear();
  for (const auto& [robot, bytes] : std::exchange(heap_by_robot_, {}))
    system_->robot(robot).memory.used_bytes -= bytes;
  running_.clear();
  stops_.clear();
  is_silent_ = false;
  connection_.slot().Abandon();
}

void RemoteProcess::Rejoin(const std::map<ObjectId, RemoteObject*>& objects) {
  objects_ = objects;
  connection_.Rejoin();
  loss_.clear();
  crashed_ = false;
  crashed_object_ = kNoObject;
}

void RemoteProcess::ReturnRegion(RCRegion* region) { marshaller_->ReleaseImported(region); }

void RemoteProcess::HandleUndelivered(const Message& message) {
  if (marshaller_ != nullptr) marshaller_->CompleteSend(message);
}

void RemoteProcess::Forget(ObjectId id) {
  for (RCRegion* region : marshaller_->TakeExportedBy(id))
    system_->object(id)->ReturnRegion(region);
  openr_wire_ToWorker to_worker = NewToWorker(openr_wire_TO_WORKER_FORGET);
  to_worker.body._u.replaced_object = id;
  connection_.Send(to_worker);
  // Waits for the answer of the worker only in lockstep.  In a free run the master waits for no
  // worker, and HandleFreeSample() receives the answer later.
  if (is_free_) return;
  const RemoteConnection::ReceivedSample to_master = connection_.Next();
  if (to_master->body._d != openr_wire_TO_MASTER_FORGOTTEN)
    connection_.Refuse("something else when it was to forget");
  HandleForgotten(*to_master);
}

void RemoteProcess::HandleForgotten(const openr_wire_ToMaster& to_master) {
  Apply(to_master, nullptr);
  marshaller_->PeerDropped(VectorOf(to_master.body._u.forgotten.dropped));
}

}  // namespace openr_host
