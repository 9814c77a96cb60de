#include "distribution/remote_object.h"

#include <OPENR/OPENRMessages.h>

#include <cstring>

#include "distribution/remote_process.h"
#include "runtime/core/hasher.h"
#include "runtime/core/system.h"

namespace openr_host {

bool RemoteObject::Dispatch(uint32_t selector, void*) {
  if (process_->is_lost()) {
    AnswerForTheLost(selector);
    return true;
  }
  try {
    process_->RunHandler(this, *running);
  } catch (const ProcessCrashed& crash) {
    lost_(this, Loss::kCrashed, crash.what());
  } catch (const ProcessLost& lost) {
    lost_(this, Loss::kGone, lost.what());
  }
  return true;
}

// The object manager need not wait for what cannot come.
void RemoteObject::AnswerForTheLost(uint32_t selector) {
  ++unheard_count_;
  if (selector > oentryDESTROY) return;
  OStatusMessage message;
  std::memset(&message, 0, sizeof message);
  message.msgType = omsgOSTATUS;
  message.status = oSUCCESS;
  system->Reply(system->TakeReplyTicket(), &message, sizeof message);
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
