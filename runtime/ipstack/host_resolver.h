// Looks up names and addresses with the host's resolver (/etc/hosts, then DNS).
#pragma once

#include <cstdint>
#include <string>

#include "runtime/ipstack/network.h"

namespace openr_host {

// Asks the host's resolver for a name and waits for the answer.  The wait takes seconds of real
// time if the resolver's servers do not answer.  But it does not change the run, because virtual
// time stands still during the wait.  Returns kNone if there was an answer; an answer without
// addresses means that there is no such host.
NetError ResolveOnHost(const std::string& name, HostInfo* host);
// Asks the host's resolver for the name of the host with the address `ip`.  Waits and returns as
// ResolveOnHost() does.
NetError ResolveAddressOnHost(uint32_t ip, HostInfo* host);

}  // namespace openr_host
