#include "distribution/remote_object.h"

#include <OPENR/OPENRMessages.h>
#include <OPENR/ObjcommMessages.h>

#include <algorithm>

#include "distribution/remote_process.h"
#include "runtime/base/hasher.h"
#include "runtime/core/api.h"
#include "runtime/core/connection_messages.h"
#include "runtime/core/system.h"

namespace openr_host {

std::unique_ptr<RemoteObject> RemoteObject::NewInstance() const {
  auto fresh = std::make_unique<RemoteObject>(system, id, robot, process_, lost_);
  fresh->name = name;
  fresh->path = path;
  fresh->boxes().set_last(boxes().last());
  fresh->set_lost(is_lost());
  fresh->undelivered_count = undelivered_count;
  return fresh;
}

void RemoteObject::SetDescription(const openr_wire_LoadedObject& in) {
  set_limits({std::clamp(in.priority, 0, 255), in.stack_bytes, in.heap_bytes});
  std::set<uint32_t> selectors;
  for (uint32_t i = 0; i < in.selectors._length; ++i)
    selectors.insert(static_cast<uint32_t>(in.selectors._buffer[i]));
  set_selectors(std::move(selectors));
  for (uint32_t i = 0; i < in.names._length; ++i)
    entry_names().SetName(in.names._buffer[i].selector, in.names._buffer[i].name);
}

bool RemoteObject::Dispatch(uint32_t, void*) {
  if (running()->kind == PayloadKind::kReady) RecordReady();
  if (process_->is_lost()) {
    HandleUndelivered(*running());
  } else if (!Run()) {
    SendEmptyReply(*running());
  }
  return true;
}

// Makes the worker run the handler of the message that is being delivered.  Returns false if the
// worker was lost.
bool RemoteObject::Run() {
  try {
    return process_->handlers().Run(this, *running());
  } catch (const ProcessCrashed& crash) {
    lost_(this, Loss::kCrashed, crash.what());
  } catch (const ProcessLost& lost) {
    lost_(this, Loss::kGone, lost.what());
  }
  return false;
}

void RemoteObject::RecordReady() {
  // Records also in the master that an observer is ready for data of this object.  If the worker is
  // lost, its record is lost too, and the master tells the restarted worker which observers are
  // ready.
  const auto& ready = *reinterpret_cast<const OReadyMessage*>(running()->payload);
  const StandingReady standing = {running()->selector, ObjectIdOf(ready.observerID.GetOID()),
                                  ready.observerID.GetSelector()};
  if (ready.command == objcommCMD_ASSERT_READY) {
    readies_.insert(standing);
  } else {
    readies_.erase(standing);
  }
}

void RemoteObject::ForgetObserver(ObjectId observer) {
  std::erase_if(readies_, [observer](const auto& ready) { return ready.observer == observer; });
}

std::vector<StandingReady> RemoteObject::StandingReadies() const {
  return {readies_.begin(), readies_.end()};
}

void RemoteObject::ReturnRegion(RCRegion* region) { process_->ReturnRegion(region); }

TakenBack RemoteObject::TakeBack(const Message& message) {
  if (process_->is_lost()) return TakenBack::kNoSubject;
  const auto& notify = *reinterpret_cast<const ONotifyMessage*>(message.payload);
  bool is_ready = false;
  TakenBack result = TakenBack::kNoSubject;
  try {
    result = process_->TakeBack(this, message, &is_ready);
  } catch (const ProcessLost& lost) {
    lost_(this, Loss::kGone, lost.what());
  }
  if (is_ready) readies_.insert({notify.subjectID.GetSelector(), message.target, message.selector});
  return result;
}

void RemoteObject::HandleUndelivered(const Message& message) {
  ++undelivered_count;
  process_->HandleUndelivered(message);
  if (message.kind == PayloadKind::kNotify) RefuseNotification(this, message);
  SendEmptyReply(message);
}

// Answers `request` in place of the lost worker, so that the sender of the request does not wait
// for ever.  The answer is empty, except for DoInit to DoDestroy: the object manager, which sends
// these, expects a status and gets oSUCCESS.
void RemoteObject::SendEmptyReply(const Message& request) {
  if (request.reply_box == 0) return;
  const CurrentScope scope(system, this);
  OStatusMessage message(oSUCCESS);
  system->requests().Reply({request.sender, request.reply_box}, &message,
                           request.selector > oentryDESTROY ? 0 : sizeof message);
}

void RemoteObject::HashState(Hasher* hasher) const {
  if (process_->is_lost()) return;
  try {
    const std::string bytes = process_->FetchState(id);
    hasher->AddBytes(bytes.data(), bytes.size());
  } catch (const ProcessLost& lost) {
    lost_(this, Loss::kAtEnd, lost.what());
  }
}

}  // namespace openr_host
