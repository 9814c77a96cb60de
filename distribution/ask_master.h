// Calls a function of WorkerCallList in the master.
#pragma once

#include "distribution/master_link.h"
#include "distribution/worker_call_list.h"

namespace openr_host {

// Waits for the result and for the output parameters, whose arguments are pointers.
template <auto kFunction, typename... Arguments>
auto AskMaster(MasterLink* master, const Arguments&... arguments) {
  using Function = call_codec::Signature<decltype(kFunction)>;
  const CallResult result =
      master->Ask(WorkerCallList::NumberOf<kFunction>(), Function::Encode(arguments...));
  return Function::Decode(result, arguments...);
}

// Does not wait; the result is lost.
template <auto kFunction, typename... Arguments>
void TellMaster(MasterLink* master, const Arguments&... arguments) {
  using Function = call_codec::Signature<decltype(kFunction)>;
  master->Tell(WorkerCallList::NumberOf<kFunction>(), Function::Encode(arguments...));
}

}  // namespace openr_host
