// Calls of functions of WorkerCallList in the master, for code in a worker.
#pragma once

#include "distribution/master_link.h"
#include "distribution/worker_call_list.h"

namespace openr_host {

// Calls `kFunction` in the master, waits, and returns its result.  Arguments for output parameters
// are pointers.
template <auto kFunction, typename... Arguments>
auto AskMaster(MasterLink* master, const Arguments&... arguments) {
  using Function = call_codec::Signature<decltype(kFunction)>;
  const CallResult result =
      master->Ask(WorkerCallList::NumberOf<kFunction>(), Function::Encode(arguments...));
  return Function::Decode(result, arguments...);
}

// Calls `kFunction` in the master without waiting for it, so there is no result.
template <auto kFunction, typename... Arguments>
void TellMaster(MasterLink* master, const Arguments&... arguments) {
  using Function = call_codec::Signature<decltype(kFunction)>;
  master->Tell(WorkerCallList::NumberOf<kFunction>(), Function::Encode(arguments...));
}

}  // namespace openr_host
