// Translates the IP addresses in programs of the robot to addresses of the host, and back
// (runtime/config/address_config.h).
#pragma once

#include <cstdint>
#include <map>
#include <utility>
#include <vector>

#include "runtime/config/address_config.h"
#include "runtime/ipstack/network.h"

namespace openr_host {

class AddressMap {
 public:
  explicit AddressMap(std::vector<AddressPair> pairs) : pairs_(std::move(pairs)) {}

  // Returns whether a pair of addresses (AddressPair) translates `robot`, an address that programs
  // use.
  bool Has(uint32_t robot) const;

  // Returns the host's address for `address`, an address that a program uses.  Returns `address`
  // itself if no pair of addresses (AddressPair) translates it.
  uint32_t ToHost(uint32_t address) const;

  // Returns the host's address for `peer`, the address to which a program talks, and remembers
  // `peer` for FromHost().  Several addresses that programs use may become the same address of the
  // host.  FromHost() then uses the port of the peer to find the address that the program has used.
  NetAddress ToHost(NetAddress peer);

  // Returns the address under which programs know the peer `host`.  This is the address that a
  // program last used for the peer.  If no program has used an address for the peer, returns
  // AddressPair::robot of the first pair with the host's address.  If there is no such pair,
  // returns `host` itself.
  NetAddress FromHost(NetAddress host) const;
  uint32_t FromHost(uint32_t host) const { return FromHost(NetAddress{host, 0}).ip; }

 private:
  static constexpr size_t kPeersMax = 1024;

  const std::vector<AddressPair> pairs_;
  // For each peer, the address that a program has used for it.  The key is the peer's address and
  // port on the host.
  std::map<std::pair<uint32_t, uint16_t>, uint32_t> peers_;
};

}  // namespace openr_host
