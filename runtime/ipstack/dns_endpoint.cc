#include "runtime/ipstack/dns_endpoint.h"

#include <EndpointTypes.h>

#include <algorithm>
#include <cstring>

#include "runtime/base/assert.h"
#include "runtime/base/hasher.h"
#include "runtime/core/system.h"
#include "runtime/ipstack/ant_message.h"
#include "runtime/ipstack/ip_stack.h"

namespace openr_host {
namespace {

// Copies the host name `from` to the field `to` of a message, cut to the size of the field, and
// fills the rest of the field with zeros.
void CopyName(char (&to)[MAXDNAME], const std::string& from) {
  std::memset(to, 0, sizeof to);
  std::memcpy(to, from.data(), std::min(from.size(), sizeof to - 1));
}

std::string NameIn(const char (&from)[MAXDNAME]) { return {from, strnlen(from, sizeof from)}; }

DNSEndpointError DnsErrorOf(const NetworkEvent& event) {
  if (event.kind == NetworkEvent::Kind::kResolved) {
    return event.host.addresses.empty() ? DNS_HOST_NOT_FOUND : DNS_SUCCESS;
  }
  return event.error == NetError::kTimeout ? DNS_TRY_AGAIN : DNS_NO_RECOVERY;
}

}  // namespace

DnsEndpoint::DnsEndpoint(IpStack* stack, ObjectId owner, int32_t pool_bytes)
    : Endpoint(stack, EndpointType_DNS, owner, pool_bytes),
      domain_(stack->parameters().wlan().dns_default_domain) {}

void DnsEndpoint::Start(const Operation& operation) {
  Operation op = operation;
  const int32_t code = op.message().dstOperation;
  if (code == DNSEndpoint_Operation_Close) return Close(op);
  if (query_) return Refuse(op, DNS_CONNECTION_BUSY);
  DNSEndpointError error = DNS_SUCCESS;
  switch (code) {
    case DNSEndpoint_Operation_SetServerAddresses:
      error = SetServers(op.As<DNSEndpointSetServerAddressesMsg>());
      break;
    case DNSEndpoint_Operation_GetServerAddresses:
      error = GetServers(&op.As<DNSEndpointGetServerAddressesMsg>());
      break;
    case DNSEndpoint_Operation_SetDefaultDomainName:
      domain_ = NameIn(op.As<DNSEndpointSetDefaultDomainNameMsg>().name);
      break;
    case DNSEndpoint_Operation_GetDefaultDomainName:
      CopyName(op.As<DNSEndpointGetDefaultDomainNameMsg>().name, domain_);
      break;
    case DNSEndpoint_Operation_GetHostByName:
    case DNSEndpoint_Operation_GetHostByAddr:
      return Query(op);
    case DNSEndpoint_Operation_GetAddress:
      error = GetAddress(&op.As<DNSEndpointGetAddressMsg>());
      break;
    case DNSEndpoint_Operation_GetAlias:
      error = GetAlias(&op.As<DNSEndpointGetAliasMsg>());
      break;
    default:
      error = DNS_OPERATION_UNKNOWN;
  }
  stack_->Answer(&op, error);
}

DNSEndpointError DnsEndpoint::SetServers(const DNSEndpointSetServerAddressesMsg& message) {
  if (message.nscount < 0 || message.nscount > MAXNS) return DNS_FAIL;
  std::vector<uint32_t>& servers = stack_->dns_servers();
  servers.clear();
  for (int i = 0; i < message.nscount; ++i) servers.push_back(message.addrList[i].Address());
  return DNS_SUCCESS;
}

DNSEndpointError DnsEndpoint::GetServers(DNSEndpointGetServerAddressesMsg* message) const {
  const std::vector<uint32_t>& servers = stack_->dns_servers();
  message->nscount = static_cast<int32>(servers.size());
  for (size_t i = 0; i < MAXNS; ++i) message->addrList[i] = i < servers.size() ? servers[i] : 0u;
  return DNS_SUCCESS;
}

DNSEndpointError DnsEndpoint::GetAddress(DNSEndpointGetAddressMsg* message) const {
  const auto index = static_cast<size_t>(message->index);
  if (message->index < 0 || index >= host_.addresses.size()) return DNS_INDEX_INVALID;
  message->address = host_.addresses[index];
  return DNS_SUCCESS;
}

// Finds an alias, by its index, of the host that the last query has found.  Alias 0 is the official
// name of the host; alias i is HostInfo::aliases[i - 1].
DNSEndpointError DnsEndpoint::GetAlias(DNSEndpointGetAliasMsg* message) const {
  const auto index = static_cast<size_t>(message->index);
  const size_t count = host_.addresses.empty() ? 0 : 1 + host_.aliases.size();
  if (message->index < 0 || index >= count) return DNS_INDEX_INVALID;
  CopyName(message->name, index == 0 ? host_.name : host_.aliases[index - 1]);
  return DNS_SUCCESS;
}

std::string DnsEndpoint::FullName(const std::string& name) const {
  if (!name.empty() && name.back() == '.') return name.substr(0, name.size() - 1);
  return domain_.empty() ? name : name + "." + domain_;
}

void DnsEndpoint::Query(const Operation& operation) {
  query_ = operation;
  answer_.reset();
  host_ = {};
  asked_us_ = stack_->system().now_us();
  if (operation.message().dstOperation == DNSEndpoint_Operation_GetHostByAddr) {
    socket_ = stack_->Open(this);
    stack_->network().ResolveAddress(
        socket_, query_->As<DNSEndpointGetHostByAddrMsg>().host_address.Address());
    return;
  }
  const std::string name = FullName(NameIn(query_->As<DNSEndpointGetHostByNameMsg>().name));
  if (name.empty()) return FinishQuery(DNS_HOST_NOT_FOUND);
  socket_ = stack_->Open(this);
  stack_->network().Resolve(socket_, name);
}

void DnsEndpoint::StoreEvent(const NetworkEvent& event) {
  if (query_) answer_ = event;
}

void DnsEndpoint::AnswerReady() {
  if (!query_) return;
  if (answer_) {
    const DNSEndpointError error = DnsErrorOf(*answer_);
    if (error == DNS_SUCCESS) host_ = answer_->host;
    host_.addresses.resize(std::min(host_.addresses.size(), kAddressesMax));
    host_.aliases.resize(std::min(host_.aliases.size(), kAddressesMax));
    FinishQuery(error);
  } else if (stack_->system().now_us() - asked_us_ >= kAnswerUs) {
    FinishQuery(DNS_TRY_AGAIN);
  }
}

// Answers the pending query for a host.  After a failure, the answer has the name that the program
// asked for, because Sony's sample NTP reads this name and uses it as an address if it is a dotted
// address.
void DnsEndpoint::FinishQuery(DNSEndpointError error) {
  ASSERT(query_.has_value());
  // Uses a generic lambda, because the messages for a query by name and by address have the same
  // fields but different types.
  const auto fill = [&](auto& message) {
    message.n_address = static_cast<int32>(host_.addresses.size());
    message.n_alias = 1 + static_cast<int32>(host_.aliases.size());
    CopyName(message.name, host_.name);
    message.host_address = host_.addresses.front();
    const std::vector<uint32_t>& servers = stack_->dns_servers();
    message.server_address = servers.empty() ? 0u : servers.front();
  };
  if (error != DNS_SUCCESS) {
    host_ = {};
  } else if (query_->message().dstOperation == DNSEndpoint_Operation_GetHostByName) {
    fill(query_->As<DNSEndpointGetHostByNameMsg>());
  } else {
    fill(query_->As<DNSEndpointGetHostByAddrMsg>());
  }
  stack_->Drop(socket_, false);
  socket_ = 0;
  Operation finished = *query_;
  query_.reset();
  answer_.reset();
  stack_->Answer(&finished, error);
}

void DnsEndpoint::Refuse(Operation operation, DNSEndpointError error) {
  stack_->Answer(&operation, error);
}

void DnsEndpoint::Close(Operation operation) {
  if (query_) FinishQuery(DNS_CONNECTION_CLOSED);
  dead_ = true;
  stack_->Answer(&operation, DNS_SUCCESS);
}

void DnsEndpoint::Drop() {
  stack_->Drop(socket_, false);
  socket_ = 0;
  dead_ = true;
}

void DnsEndpoint::HashState(Hasher* hasher) const {
  hasher->AddText(domain_);
  hasher->AddText(host_.name);
  for (const std::string& alias : host_.aliases) hasher->AddText(alias);
  for (const uint32_t address : host_.addresses) hasher->Add(address);
  hasher->Add(query_.has_value());
  if (query_) hasher->Add(AntMessageHash(query_->message()));
}

}  // namespace openr_host
