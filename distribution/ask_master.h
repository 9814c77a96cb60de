// Lets code in a worker process call functions of the master process.  WorkerCallList lists these
// functions.
#pragma once

#include "distribution/master_link.h"
#include "distribution/worker_call_list.h"

namespace openr_host {

// Calls `kFunction`, a function of the master that workers may call (WorkerCallList), waits for the
// answer, and returns the function's result.  The argument for an output parameter is a pointer.
template <auto kFunction, typename... Arguments>
auto AskMaster(MasterLink* master, const Arguments&... arguments) {
  using Function = call_codec::Signature<decltype(kFunction)>;
  const CallResult result =
      master->Ask(WorkerCallList::NumberOf<kFunction>(), Function::Encode(arguments...));
  return Function::Decode(result, arguments...);
}

// Makes the master call `kFunction`, one of its functions that workers may call (WorkerCallList),
// with `arguments`.  Does not wait for the call, so there is no result.
template <auto kFunction, typename... Arguments>
void TellMaster(MasterLink* master, const Arguments&... arguments) {
  using Function = call_codec::Signature<decltype(kFunction)>;
  master->Tell(WorkerCallList::NumberOf<kFunction>(), Function::Encode(arguments...));
}

}  // namespace openr_host
