// Implements Worker::TakeBack().
#include <OPENR/ObjcommMessages.h>

#include <algorithm>
#include <new>
#include <stdexcept>
#include <vector>

#include "distribution/worker.h"
#include "runtime/core/api.h"
#include "runtime/core/system.h"

namespace openr_host {
namespace {

// Fills `refused` with the notification that `subject` had sent to the observer of `returned`.
// `returned` is a ready that gives back the regions of the notification.  The ids and sizes of the
// regions are left out, because the subject needs only the regions.
void FillRefused(const Message& returned, const SubjectID& subject, uint32_t notifications,
                 Message* refused) {
  const auto& ready = *reinterpret_cast<const OReadyMessage*>(returned.payload);
  refused->target = ObjectIdOf(ready.observerID.GetOID());
  refused->selector = ready.observerID.GetSelector();
  refused->kind = PayloadKind::kNotify;
  auto& notify = *new (refused->payload) ONotifyMessage;
  notify.subjectID = subject;
  notify.numOfNotify = static_cast<short>(notifications);
  notify.numOfData = static_cast<short>(ready.numOfData);
  for (int i = 0; i < ready.numOfData; ++i) notify.data[i].srcRCR = ready.rcRegion[i];
}

}  // namespace

// Makes the data of a notification that the master has refused pending again in the subject of this
// process that has sent them.  The master refused the notification only when the processor time of
// the handler that sent it was over.  This handler has ended, so it cannot be told.
void Worker::TakeBack(const openr_wire_TakeBack& in) {
  Object* const object = system_->object(in.message.target);
  if (object == nullptr) throw std::runtime_error("data of an object that is not there");
  if (in.now_us > system_->now_us()) system_->RunUntil(in.now_us);
  const OwnedMessage returned = system_->queue().Allocate();
  const std::string problem = marshaller_->Decode(in.message, returned.get());
  if (!problem.empty()) throw std::runtime_error("malformed data to take back: " + problem);
  if (returned->kind != PayloadKind::kReady || in.notifications < 1 ||
      in.notifications > MAX_NUM_DATA)
    throw std::runtime_error("malformed data to take back");
  const OwnedMessage refused = system_->queue().Allocate();
  FillRefused(*returned, OServiceEntry(OidOf(object->id), in.message.selector), in.notifications,
              refused.get());
  const bool has_data = object->TakeBack(*refused) == TakenBack::kPending;
  if (!has_data) marshaller_->UndoDecode();
  const StandingReady ready = {in.message.selector, refused->target, refused->selector};
  const std::vector<StandingReady> readies = object->StandingReadies();
  const bool is_ready = std::find(readies.begin(), readies.end(), ready) != readies.end();
  openr_wire_ToMaster to_master = NewToMaster(openr_wire_TO_MASTER_TOOK_BACK);
  to_master.body._u.took_back = {object->id, has_data, is_ready,
                                 object->statistics().dropped_count(), object->CountPending()};
  MoveEffectsTo(&to_master);
  Send(to_master);
  arena_.Clear();
}

}  // namespace openr_host
