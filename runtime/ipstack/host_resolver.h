// Names and addresses by the host's resolver (/etc/hosts, then DNS).
#pragma once

#include <cstdint>
#include <string>

#include "runtime/ipstack/network.h"

namespace openr_host {

// Both wait for the host's resolver, which may take seconds of wall time when its servers
// do not answer; virtual time stands still meanwhile, so runs do not differ.  The error is
// kNone when the question was answered: no addresses then mean that there is no such host.
NetError ResolveOnHost(const std::string& name, HostInfo* host);
NetError ResolveAddressOnHost(uint32_t ip, HostInfo* host);

}  // namespace openr_host
