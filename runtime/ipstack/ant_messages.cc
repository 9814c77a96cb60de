// Constructors of the messages that set parameters of the network stack or ask for names and
// addresses (DNS).  Functions that print an antModuleRef, a program's reference to a TCP, UDP or
// DNS endpoint.
#include <DNSEndpointMsg.h>
#include <OPENR/OSyslog.h>
#include <antEnvMsg.h>
#include <fmt/format.h>

#include <algorithm>
#include <cstring>

namespace {

// Copies the text `from` into the array `to`, cut to N - 1 characters.  The rest of the array, at
// least one character, becomes NUL.
template <size_t N>
void CopyText(char (&to)[N], const char* from) {
  std::memset(to, 0, N);
  if (from != nullptr) std::memcpy(to, from, std::min(std::strlen(from), N - 1));
}

}  // namespace

void antModuleRef::Print() const { osysprint("module %u\n", index); }

std::ostream& operator<<(std::ostream& out, const antModuleRef& ref) {
  return out << fmt::format("module {}", ref.index);
}

// ---- Messages about parameters of the network stack

antEnvInitGetParamMsg::antEnvInitGetParamMsg() : antEnvInitGetParamMsg("") {}
antEnvInitGetParamMsg::antEnvInitGetParamMsg(const char* name)
    : antEnvMsg(antEnv_Operation_InitGetParam, Entry_antEnv_Initialize),
      paramType(0),
      error(ANT_FAIL) {
  CopyText(key, name);
  CopyText(value.str, "");
}

antEnvInitSetParamMsg::antEnvInitSetParamMsg() : antEnvInitSetParamMsg("", "") {}
antEnvInitSetParamMsg::antEnvInitSetParamMsg(const char* name, int32 number)
    : antEnvInitSetParamMsg(name, "") {
  paramType = antEnv_InitParam_Int32;
  value.i32 = number;
}
antEnvInitSetParamMsg::antEnvInitSetParamMsg(const char* name, const char* text)
    : antEnvMsg(antEnv_Operation_InitSetParam, Entry_antEnv_Initialize),
      paramType(antEnv_InitParam_String),
      error(ANT_FAIL) {
  CopyText(key, name);
  CopyText(value.str, text);
}

antEnvInitStartMsg::antEnvInitStartMsg()
    : antEnvMsg(antEnv_Operation_InitStart, Entry_antEnv_Initialize), error(ANT_FAIL) {}

// ---- Messages to a DNS endpoint

DNSEndpointSetServerAddressesMsg::DNSEndpointSetServerAddressesMsg()
    : DNSEndpointBaseMsg(DNSEndpoint_Operation_SetServerAddresses), nscount(0) {}
DNSEndpointSetServerAddressesMsg::DNSEndpointSetServerAddressesMsg(antModuleRef& module,
                                                                   int32 count, IPAddress* list)
    : DNSEndpointBaseMsg(module, DNSEndpoint_Operation_SetServerAddresses),
      nscount(std::clamp(count, 0, MAXNS)) {
  std::copy_n(list, nscount, addrList);
}

DNSEndpointGetServerAddressesMsg::DNSEndpointGetServerAddressesMsg()
    : DNSEndpointBaseMsg(DNSEndpoint_Operation_GetServerAddresses), nscount(0) {}
DNSEndpointGetServerAddressesMsg::DNSEndpointGetServerAddressesMsg(antModuleRef& module)
    : DNSEndpointBaseMsg(module, DNSEndpoint_Operation_GetServerAddresses), nscount(0) {}

DNSEndpointSetDefaultDomainNameMsg::DNSEndpointSetDefaultDomainNameMsg()
    : DNSEndpointBaseMsg(DNSEndpoint_Operation_SetDefaultDomainName) {
  CopyText(name, "");
}
DNSEndpointSetDefaultDomainNameMsg::DNSEndpointSetDefaultDomainNameMsg(antModuleRef& module,
                                                                       const char* domain)
    : DNSEndpointBaseMsg(module, DNSEndpoint_Operation_SetDefaultDomainName) {
  CopyText(name, domain);
}

DNSEndpointGetDefaultDomainNameMsg::DNSEndpointGetDefaultDomainNameMsg()
    : DNSEndpointBaseMsg(DNSEndpoint_Operation_GetDefaultDomainName) {
  CopyText(name, "");
}
DNSEndpointGetDefaultDomainNameMsg::DNSEndpointGetDefaultDomainNameMsg(antModuleRef& module)
    : DNSEndpointBaseMsg(module, DNSEndpoint_Operation_GetDefaultDomainName) {
  CopyText(name, "");
}

DNSEndpointGetHostByNameMsg::DNSEndpointGetHostByNameMsg()
    : DNSEndpointBaseMsg(DNSEndpoint_Operation_GetHostByName), n_address(0), n_alias(0) {
  CopyText(name, "");
}
DNSEndpointGetHostByNameMsg::DNSEndpointGetHostByNameMsg(antModuleRef& module, const char* host)
    : DNSEndpointBaseMsg(module, DNSEndpoint_Operation_GetHostByName), n_address(0), n_alias(0) {
  CopyText(name, host);
}

DNSEndpointGetHostByAddrMsg::DNSEndpointGetHostByAddrMsg()
    : DNSEndpointBaseMsg(DNSEndpoint_Operation_GetHostByAddr), n_address(0), n_alias(0) {
  CopyText(name, "");
}
DNSEndpointGetHostByAddrMsg::DNSEndpointGetHostByAddrMsg(antModuleRef& module, IPAddress address)
    : DNSEndpointBaseMsg(module, DNSEndpoint_Operation_GetHostByAddr),
      host_address(address),
      n_address(0),
      n_alias(0) {
  CopyText(name, "");
}

DNSEndpointGetAddressMsg::DNSEndpointGetAddressMsg()
    : DNSEndpointBaseMsg(DNSEndpoint_Operation_GetAddress), index(0) {}
DNSEndpointGetAddressMsg::DNSEndpointGetAddressMsg(antModuleRef& module, int number)
    : DNSEndpointBaseMsg(module, DNSEndpoint_Operation_GetAddress), index(number) {}

DNSEndpointGetAliasMsg::DNSEndpointGetAliasMsg()
    : DNSEndpointBaseMsg(DNSEndpoint_Operation_GetAlias), index(0) {
  CopyText(name, "");
}
DNSEndpointGetAliasMsg::DNSEndpointGetAliasMsg(antModuleRef& module, int number)
    : DNSEndpointBaseMsg(module, DNSEndpoint_Operation_GetAlias), index(number) {
  CopyText(name, "");
}

DNSEndpointCloseMsg::DNSEndpointCloseMsg() : DNSEndpointBaseMsg(DNSEndpoint_Operation_Close) {}
DNSEndpointCloseMsg::DNSEndpointCloseMsg(antModuleRef& module)
    : DNSEndpointBaseMsg(module, DNSEndpoint_Operation_Close) {}
