#include "distribution/remote_object.h"

#include "distribution/remote_process.h"
#include "runtime/core/hasher.h"

namespace openr_host {

bool RemoteObject::Dispatch(uint32_t, void*) {
  if (process_->is_lost()) return true;  // nobody hears it
  try {
    process_->RunHandler(this, *running);
  } catch (const ProcessLost& lost) {
    lost_(this, lost.what());
  }
  return true;
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
