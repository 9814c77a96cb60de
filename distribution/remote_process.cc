#include "distribution/remote_process.h"

#include <OPENR/ObjcommMessages.h>
#include <fmt/format.h>

#include <algorithm>
#include <new>
#include <utility>

#include "distribution/remote_object.h"
#include "runtime/core/api.h"
#include "runtime/core/system.h"

namespace openr_host {

RemoteProcess::RemoteProcess(Bus* bus, std::string name, bool is_external,
                             std::function<std::string()> health,
                             std::function<void(const std::string&)> say)
    : connection_(bus, std::move(name), is_external, std::move(health), std::move(say)) {}

std::string RemoteProcess::FetchState(ObjectId object) {
  // Returns nothing in a free run.  The object does not stop in a free run, so its state may change
  // while it is read.
  if (handlers_.is_free()) return "";
  openr_wire_ToWorker to_worker = NewToWorker(openr_wire_TO_WORKER_ASK_STATE);
  to_worker.body._u.state_of = object;
  connection_.Send(to_worker);
  const RemoteConnection::ReceivedSample to_master = connection_.Next();
  if (to_master->body._d != openr_wire_TO_MASTER_STATE) connection_.Refuse("no state");
  const openr_wire_State& state = to_master->body._u.state;
  for (uint32_t i = 0; i < state.regions._length; ++i) {
    const openr_wire_RegionBytes& in = state.regions._buffer[i];
    // Does not copy the worker's bytes of a region that the master has received in a notification
    // and not given back.  An observer may have changed the region, so the master's copy may be
    // newer than the worker's.
    if (resources_.marshaller()->HasImported(in.region)) continue;
    char* const base = resources_.system()->regions().BaseOf(in.region);
    if (base == nullptr)
      connection_.Refuse(fmt::format("bytes of region {:#x}, which does not exist", in.region));
    if (const size_t size = resources_.system()->regions().SizeOf(in.region);
        in.bytes._length != size) {
      connection_.Refuse(fmt::format("{} bytes of region {:#x}, which has {} bytes",
                                     in.bytes._length, in.region, size));
    }
    if (!resources_.calls()->HasRegion(in.region))
      connection_.Refuse(fmt::format("bytes of region {:#x}, which is not its own", in.region));
    std::copy_n(in.bytes._buffer, in.bytes._length, reinterpret_cast<uint8_t*>(base));
  }
  return StringOf(state.subjects);
}

TakenBack RemoteProcess::TakeBack(const RemoteObject* sender, const Message& message,
                                  bool* is_ready) {
  if (handlers_.is_free()) return TakenBack::kNoSubject;
  const auto& notify = *reinterpret_cast<const ONotifyMessage*>(message.payload);
  // Puts the regions into a ready, because a ready is the kind of message that can give regions
  // back.
  const OwnedMessage returned =
      resources_.system()->NewMessage(sender->id, notify.subjectID.GetSelector());
  auto& ready = *new (returned->payload) OReadyMessage;
  ready.command = objcommCMD_DEASSERT_READY;
  ready.observerID = OServiceEntry(OidOf(message.target), message.selector);
  ready.numOfData = notify.numOfData;
  for (int i = 0; i < notify.numOfData; ++i) ready.rcRegion[i] = notify.data[i].srcRCR;
  returned->size = sizeof ready;
  returned->kind = PayloadKind::kReady;
  WireArena arena;
  openr_wire_ToWorker to_worker = NewToWorker(openr_wire_TO_WORKER_TAKE_BACK);
  openr_wire_TakeBack& take_back = to_worker.body._u.take_back;
  take_back.now_us = resources_.system()->now_us();
  take_back.notifications = static_cast<uint32_t>(notify.numOfNotify);
  resources_.marshaller()->Encode(*returned, nullptr, &arena, &take_back.message);
  connection_.Send(to_worker);
  const RemoteConnection::ReceivedSample to_master = connection_.Next();
  if (to_master->body._d != openr_wire_TO_MASTER_TOOK_BACK ||
      to_master->body._u.took_back.object != sender->id)
    connection_.Refuse("something else when it was to take data back");
  effects_.ApplyTookBack(*to_master);
  if (!to_master->body._u.took_back.has_data) return TakenBack::kNoObserver;
  *is_ready = to_master->body._u.took_back.is_ready;
  resources_.marshaller()->CompleteSend(*returned);
  return TakenBack::kPending;
}

void RemoteProcess::SetLost() {
  connection_.set_lost();
  resources_.SetLost(true);
}

void RemoteProcess::ReleaseAll() {
  // Calls SetLost() first, because resources_.ReleaseAll() posts messages to the master's stand-ins
  // for the worker's objects, and after SetLost() the stand-ins do not send these messages to the
  // worker.
  SetLost();
  resources_.ReleaseAll();
  free_run_.ForgetHandlers();
  connection_.slot().Abandon();
}

void RemoteProcess::Rejoin(const std::map<ObjectId, RemoteObject*>& objects) {
  resources_.Replace(objects);
  connection_.Rejoin();
  resources_.SetLost(false);
  free_run_.ForgetLoss();
}

void RemoteProcess::Forget(ObjectId id) {
  for (RCRegion* region : resources_.marshaller()->TakeExportedBy(id))
    resources_.system()->object(id)->ReturnRegion(region);
  openr_wire_ToWorker to_worker = NewToWorker(openr_wire_TO_WORKER_FORGET);
  to_worker.body._u.replaced_object = id;
  connection_.Send(to_worker);
  // Waits for the answer of the worker only in lockstep.  In a free run the master waits for no
  // worker, and RemoteFreeRun handles the answer later.
  if (handlers_.is_free()) return;
  const RemoteConnection::ReceivedSample to_master = connection_.Next();
  if (to_master->body._d != openr_wire_TO_MASTER_FORGOTTEN)
    connection_.Refuse("something else when it was to forget");
  effects_.ApplyForgotten(*to_master);
}

bool RemoteProcess::SendEnd(const std::string& why) {
  resources_.End();
  const bool is_told = connection_.SendEnd(why);
  if (connection_.is_lost()) SetLost();
  return is_told;
}

}  // namespace openr_host
