// The part of RemoteProcess that releases regions, messages and connections when a worker was lost,
// or when an object of another process was replaced.
#include "distribution/remote_object.h"
#include "distribution/remote_process.h"
#include "runtime/core/api.h"
#include "runtime/core/connection_state.h"
#include "runtime/core/system.h"

namespace openr_host {

size_t RemoteProcess::CountUndelivered() const {
  size_t count = 0;
  for (const auto& [id, box] : running_) {
    const Message& message = *resources_.objects().at(id)->handler.running;
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
  resources_.ReleaseAll();
  running_.clear();
  stops_.clear();
  is_silent_ = false;
  connection_.slot().Abandon();
}

void RemoteProcess::Rejoin(const std::map<ObjectId, RemoteObject*>& objects) {
  resources_.Replace(objects);
  connection_.Rejoin();
  loss_.clear();
  crashed_ = false;
  crashed_object_ = kNoObject;
}

void RemoteProcess::Forget(ObjectId id) {
  for (RCRegion* region : resources_.marshaller()->TakeExportedBy(id))
    resources_.system()->object(id)->ReturnRegion(region);
  openr_wire_ToWorker to_worker = NewToWorker(openr_wire_TO_WORKER_FORGET);
  to_worker.body._u.replaced_object = id;
  connection_.Send(to_worker);
  // Waits for the answer of the worker only in lockstep.  In a free run the master waits for no
  // worker, and HandleFreeSample() receives the answer later.
  if (is_free_) return;
  const RemoteConnection::ReceivedSample to_master = connection_.Next();
  if (to_master->body._d != openr_wire_TO_MASTER_FORGOTTEN)
    connection_.Refuse("something else when it was to forget");
  effects_.ApplyForgotten(*to_master);
}

}  // namespace openr_host
