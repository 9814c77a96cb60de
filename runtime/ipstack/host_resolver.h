// Looks up names and addresses with the host's resolver (/etc/hosts, then DNS).
#pragma once

#include <cstdint>
#include <string>

#include "runtime/ipstack/network.h"

namespace openr_host {

// Both functions wait for the host's resolver.  That takes seconds of wall time if its servers do
// not answer, but virtual time stands still, so runs do not differ.  The error is kNone if there
// was an answer; an answer without addresses means that there is no such host.
NetError ResolveOnHost(const std::string& name, HostInfo* host);
NetError ResolveAddressOnHost(uint32_t ip, HostInfo* host);

}  // namespace openr_host
