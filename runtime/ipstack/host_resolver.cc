#include "runtime/ipstack/host_resolver.h"

#include <arpa/inet.h>
#include <netdb.h>
#include <netinet/in.h>
#include <sys/socket.h>

namespace openr_host {
namespace {

NetError ErrorOf(int status) {
  switch (status) {
    case 0:
    case EAI_NONAME:
#ifdef EAI_NODATA
    case EAI_NODATA:
#endif
      return NetError::kNone;
    case EAI_AGAIN:
      return NetError::kTimeout;
    default:
      return NetError::kFailed;
  }
}

}  // namespace

NetError ResolveOnHost(const std::string& name, HostInfo* host) {
  addrinfo hints{};
  hints.ai_family = AF_INET;
  // Asks the resolver for addresses of one socket type only.  Otherwise the resolver would return
  // each address once for each type.
  hints.ai_socktype = SOCK_STREAM;
  hints.ai_flags = AI_CANONNAME;
  addrinfo* list = nullptr;
  const int status = getaddrinfo(name.c_str(), nullptr, &hints, &list);
  if (status != 0) return ErrorOf(status);
  host->name = list->ai_canonname != nullptr ? list->ai_canonname : name;
  for (const addrinfo* a = list; a != nullptr; a = a->ai_next) {
    host->addresses.push_back(
        ntohl(reinterpret_cast<const sockaddr_in*>(a->ai_addr)->sin_addr.s_addr));
  }
  freeaddrinfo(list);
  return NetError::kNone;
}

NetError ResolveAddressOnHost(uint32_t ip, HostInfo* host) {
  sockaddr_in address{};
  address.sin_family = AF_INET;
  address.sin_addr.s_addr = htonl(ip);
  char name[NI_MAXHOST];
  const int status = getnameinfo(reinterpret_cast<const sockaddr*>(&address), sizeof address, name,
                                 sizeof name, nullptr, 0, NI_NAMEREQD);
  if (status != 0) return ErrorOf(status);
  host->name = name;
  host->addresses = {ip};
  return NetError::kNone;
}

}  // namespace openr_host
