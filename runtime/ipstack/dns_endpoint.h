// DnsEndpoint: answers a program's queries for names and addresses of hosts.
//
// The answers come from the Network, which asks the host's resolver or looks into a table.  The
// endpoint has a list of DNS servers only because programs set and read this list.  Every answer
// says that the first server of the list has answered.
#pragma once

#include <DNSEndpointMsg.h>

#include <cstdint>
#include <optional>
#include <string>

#include "runtime/ipstack/endpoint.h"

namespace openr_host {

class DnsEndpoint : public Endpoint {
 public:
  DnsEndpoint(IpStack* stack, ObjectId owner, int32_t pool_bytes);

  // The largest number of addresses, and of aliases, that a DNS endpoint keeps of the answer to one
  // query; our choice.
  static constexpr size_t kAddressesMax = 16;
  // The time limit for the answer to a DNS query, in virtual time; our choice.  After this time the
  // query fails with DNS_TRY_AGAIN.
  static constexpr int64_t kAnswerUs = 30'000'000;

  void Start(const Operation& operation) override;
  void StoreEvent(const NetworkEvent& event) override;
  void AnswerReady() override;
  bool WaitsForNetwork() const override { return !dead_ && query_.has_value(); }
  void Drop() override;
  void HashState(Hasher* hasher) const override;

 private:
  DNSEndpointError SetServers(const DNSEndpointSetServerAddressesMsg& message);
  DNSEndpointError GetServers(DNSEndpointGetServerAddressesMsg* message) const;
  DNSEndpointError GetAddress(DNSEndpointGetAddressMsg* message) const;
  DNSEndpointError GetAlias(DNSEndpointGetAliasMsg* message) const;
  void Query(const Operation& operation);
  void Close(Operation operation);
  void FinishQuery(DNSEndpointError error);
  void Refuse(Operation operation, DNSEndpointError error);

  // Returns the complete form of the host name `name`, which a program has given.  Removes a final
  // dot; to a name without a final dot, appends the default domain.
  std::string FullName(const std::string& name) const;

  std::string domain_;    // the default domain; "" if there is none
  NetHandle socket_ = 0;  // the handle of the pending query
  int64_t asked_us_ = 0;
  std::optional<Operation> query_;  // the pending GetHostByName or GetHostByAddr
  std::optional<NetworkEvent> answer_;
  HostInfo host_;  // the host that was found last, for GetAddress and GetAlias
};

}  // namespace openr_host
