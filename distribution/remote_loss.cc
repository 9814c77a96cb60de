// The part of RemoteProcess that handles regions, messages and connections of a lost worker.
#include <algorithm>
#include <utility>
#include <vector>

#include "distribution/remote_object.h"
#include "distribution/remote_process.h"
#include "runtime/core/api.h"
#include "runtime/core/connection_state.h"
#include "runtime/core/system.h"

namespace openr_host {

// Gives the exported regions back to their subjects, in a deassert in the name of each observer,
// because the observers will not be ready any more.
void RemoteProcess::ReturnExported() {
  using Entry = std::pair<ObjectId, uint32_t>;
  // The regions to give back, by observer and subject.
  std::map<std::pair<Entry, Entry>, std::vector<RCRegion*>> regions;
  for (const Marshaller::ExportedRegion& exported : marshaller_->TakeExported())
    regions[{{exported.observer, exported.observer_selector},
             {exported.subject, exported.subject_selector}}]
        .push_back(exported.region);
  for (const auto& [ends, exported] : regions) {
    const auto& [observer, subject] = ends;
    const auto found = objects_.find(observer.first);
    if (found == objects_.end()) continue;
    // A ready message has room for MAX_NUM_DATA regions, so more regions need more messages.
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
  // is_lost_ is set first, because the calls below post messages to the stand-ins, which must not
  // send them to the worker.
  is_lost_ = true;
  ReturnExported();
  marshaller_->PeerIsLost();
  for (const auto& [id, object] : objects_) {
    // A stand-in whose handler waits for a reply is woken, because its worker is lost and can no
    // longer end the handler.
    if (object->handler.blocked != nullptr) WakeHandler(id, object->handler.blocked_box);
  }
  calls_->ReleasePins();
  // Counters and heap use begin anew with the next process.
  dropped_.clear();
  for (const auto& [robot, bytes] : std::exchange(heap_by_robot_, {}))
    system_->robot(robot).memory.used_bytes -= bytes;
  running_.clear();
  stops_.clear();
  is_silent_ = false;
  slot_.Abandon();
}

void RemoteProcess::Rejoin(const std::map<ObjectId, RemoteObject*>& objects) {
  objects_ = objects;
  // Stand-ins that still wait for the old process compare this number and see that it has ended.
  ++session_;
  is_lost_ = false;
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
  Send(to_worker);
  // In a free run the answer comes like any other sample, see HandleFreeSample().
  if (is_free_) return;
  const ReceivedSample to_master = Next();
  if (to_master->body._d != openr_wire_TO_MASTER_FORGOTTEN)
    Refuse("something else when it was to forget");
  HandleForgotten(*to_master);
}

void RemoteProcess::HandleForgotten(const openr_wire_ToMaster& to_master) {
  Apply(to_master, nullptr);
  marshaller_->PeerDropped(VectorOf(to_master.body._u.forgotten.dropped));
}

}  // namespace openr_host
