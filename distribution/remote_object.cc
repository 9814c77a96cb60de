#include "distribution/remote_object.h"

#include <OPENR/OPENRMessages.h>
#include <OPENR/ObjcommMessages.h>

#include <algorithm>
#include <cstring>
#include <new>

#include "distribution/remote_process.h"
#include "runtime/core/api.h"
#include "runtime/core/hasher.h"
#include "runtime/core/system.h"

namespace openr_host {

std::unique_ptr<RemoteObject> RemoteObject::NewOne() const {
  auto fresh = std::make_unique<RemoteObject>(system, id, robot, process_, lost_);
  fresh->name = name;
  fresh->path = path;
  fresh->last_box = last_box;
  fresh->unheard_count = unheard_count;
  return fresh;
}

bool RemoteObject::Dispatch(uint32_t, void*) {
  if (running->kind == PayloadKind::kReady) NoteReady();
  if (process_->is_lost()) {
    NotHeard();
  } else if (Run()) {
    return true;
  }
  AnswerForTheLost();
  return true;
}

// False when the process was lost.
bool RemoteObject::Run() {
  try {
    return process_->RunHandler(this, *running);
  } catch (const ProcessCrashed& crash) {
    lost_(this, Loss::kCrashed, crash.what());
  } catch (const ProcessLost& lost) {
    lost_(this, Loss::kGone, lost.what());
  }
  return false;
}

void RemoteObject::NoteReady() {
  const auto& ready = *reinterpret_cast<const OReadyMessage*>(running->payload);
  const StandingReady standing = {running->selector, ObjectIdOf(ready.observerID.GetOID()),
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

void RemoteObject::TakeBack(RCRegion* region) { process_->TakeBack(region); }

void RemoteObject::NotHeard() {
  ++unheard_count;
  process_->Unheard(*running);
  if (running->kind == PayloadKind::kNotify) Refuse();
}

// Nobody need wait for what cannot come: the object manager is told that all is well, others get
// an empty answer.
void RemoteObject::AnswerForTheLost() {
  if (running->reply_box == 0) return;
  OStatusMessage message;
  std::memset(&message, 0, sizeof message);
  message.msgType = omsgOSTATUS;
  message.status = oSUCCESS;
  system->Reply(system->TakeReplyTicket(), &message,
                running->selector > oentryDESTROY ? 0 : sizeof message);
}

// A notification that nobody hears: its regions go back, and the subject need not wait.
void RemoteObject::Refuse() {
  const auto& notify = *reinterpret_cast<const ONotifyMessage*>(running->payload);
  std::vector<RCRegion*> regions;
  for (int i = 0; i < notify.numOfData; ++i) regions.push_back(notify.data[i].srcRCR);
  Deassert(running->selector, notify.subjectID, regions);
}

void RemoteObject::Deassert(uint32_t selector, const SubjectID& subject,
                            const std::vector<RCRegion*>& regions) {
  const CurrentScope scope(system, this);
  Message* const message = system->NewMessage(ObjectIdOf(subject.GetOID()), subject.GetSelector());
  auto& ready = *new (message->payload) OReadyMessage;
  ready.msgType = omsgREADY_V22;
  ready.command = objcommCMD_DEASSERT_READY;
  ready.observerID = OServiceEntry(OidOf(id), selector);
  ready.numOfData = static_cast<int>(regions.size());
  std::copy(regions.begin(), regions.end(), ready.rcRegion);
  message->size = sizeof ready;
  message->kind = PayloadKind::kReady;
  system->Post(message);
}

void RemoteObject::HashState(Hasher* hasher) const {
  if (process_->is_lost()) return;
  try {
    const std::string bytes = process_->FetchState(id);
    hasher->AddBytes(bytes.data(), bytes.size());
  } catch (const ProcessLost& lost) {
    process_->set_lost();
    system->AddFindingAbout(this, Severity::kError, lost.what());
  }
}

}  // namespace openr_host
