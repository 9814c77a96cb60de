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

  // Returns whether the configuration has an entry for the address `robot`, as programs know it.
  bool Has(uint32_t robot) const;

  // Returns the host's address for `address`, which a program uses, or `address` itself if it has
  // no entry.
  uint32_t ToHost(uint32_t address) const;

  // Translates the address of `peer`, to which a program talks, and remembers the peer.  Several
  // addresses of programs may map to one address of the host, and FromHost() distinguishes them by
  // the port.
  NetAddress ToHost(NetAddress peer);

  // Returns the address under which programs know `host`: the address that a program last used for
  // this peer, else that of the first entry with `host`, else `host` itself.
  NetAddress FromHost(NetAddress host) const;
  uint32_t FromHost(uint32_t host) const { return FromHost(NetAddress{host, 0}).ip; }

 private:
  static constexpr size_t kPeersMax = 1024;

  const std::vector<AddressPair> pairs_;
  // key: the peer's address and port on the host
  std::map<std::pair<uint32_t, uint16_t>, uint32_t> peers_;
};

}  // namespace openr_host
