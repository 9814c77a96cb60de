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

bool RemoteObject::Dispatch(uint32_t, void*) {
  if (!process_->is_lost()) {
    try {
      process_->RunHandler(this, *running);
      return true;
    } catch (const ProcessCrashed& crash) {
      lost_(this, Loss::kCrashed, crash.what());
    } catch (const ProcessLost& lost) {
      lost_(this, Loss::kGone, lost.what());
    }
  } else {
    ++unheard_count_;
    if (running->kind == PayloadKind::kNotify) Refuse();
  }
  AnswerForTheLost();
  return true;
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
  } catch (const ProcessLost&) {
    process_->set_lost();
  }
}

}  // namespace openr_host
