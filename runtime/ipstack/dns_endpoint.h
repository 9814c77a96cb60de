// A DNS endpoint: names and addresses of hosts.
//
// The network answers, from the host's resolver or a table; the list of servers is kept
// for programs that set and read it, and the first of them is named as who answered.
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

  static constexpr size_t kAddressesMax = 16;       // kept of one answer; as many aliases
  static constexpr int64_t kAnswerUs = 30'000'000;  // virtual; then DNS_TRY_AGAIN

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

  // What a program's name means: without its final dot, or in the default domain.
  std::string FullName(const std::string& name) const;

  std::string domain_;    // default domain, "" for none
  NetHandle socket_ = 0;  // of the question that is out
  int64_t asked_us_ = 0;
  std::optional<Operation> query_;  // GetHostByName or GetHostByAddr
  std::optional<NetworkEvent> answer_;
  HostInfo host_;  // last one found
};

}  // namespace openr_host
