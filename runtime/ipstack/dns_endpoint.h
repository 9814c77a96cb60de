// A DNS endpoint: answers questions for names and addresses of hosts.
//
// The answers come from the Network: the host's resolver or a table.  The list of DNS servers is
// kept only for programs that set and read it; the first one is named as the server that has
// answered.
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

  // Limit for the addresses kept of one answer, and for its aliases.
  static constexpr size_t kAddressesMax = 16;
  // The time limit for an answer, in virtual time; the error after it is DNS_TRY_AGAIN.
  static constexpr int64_t kAnswerUs = 30'000'000;

  void Start(const Operation& operation) override;
  void Take(const NetworkEvent& event) override;
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

  // Completes a program's name: without its final dot, or with the default domain.
  std::string FullName(const std::string& name) const;

  std::string domain_;    // default domain; "": none
  NetHandle socket_ = 0;  // handle for the question that is being answered
  int64_t asked_us_ = 0;
  std::optional<Operation> query_;  // GetHostByName or GetHostByAddr
  std::optional<NetworkEvent> answer_;
  HostInfo host_;  // the last host found
};

}  // namespace openr_host
