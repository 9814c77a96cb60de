// Translates addresses between programs and the host (runtime/config/address_config.h).
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

  // Returns whether the configuration has an entry for a program's address.
  bool Has(uint32_t robot) const;

  // Returns the host's address for a program's `address`; the same address if there is no entry.
  uint32_t ToHost(uint32_t address) const;

  // Does the same for a peer that a program talks to, and remembers the peer: several addresses of
  // programs may map to one of the host, and FromHost() tells them apart by the port.
  NetAddress ToHost(NetAddress peer);

  // Returns the address under which programs know `host`: the one that a program last used for it,
  // else the first entry for it, else the same address.
  NetAddress FromHost(NetAddress host) const;
  uint32_t FromHost(uint32_t host) const { return FromHost(NetAddress{host, 0}).ip; }

 private:
  static constexpr size_t kPeersMax = 1024;

  const std::vector<AddressPair> pairs_;
  std::map<std::pair<uint32_t, uint16_t>, uint32_t> peers_;  // key: address and port on the host
};

}  // namespace openr_host
