// Addresses as programs know them, to those of the host and back (runtime/config/address_config.h).
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

  // Whether something is said of a program's address.
  bool Has(uint32_t robot) const;

  // Where a program's `address` is; itself when nothing is said of it.
  uint32_t ToHost(uint32_t address) const;

  // The same for a peer that a program speaks to.  It is kept, because several addresses of
  // programs may be one of the host: FromHost() tells them apart by the port.
  NetAddress ToHost(NetAddress peer);

  // How programs know `host`: as the address under which a program spoke to it last, else as the
  // first one given for it; itself when there is none.
  NetAddress FromHost(NetAddress host) const;
  uint32_t FromHost(uint32_t host) const { return FromHost(NetAddress{host, 0}).ip; }

 private:
  static constexpr size_t kPeersMax = 1024;

  const std::vector<AddressPair> pairs_;
  std::map<std::pair<uint32_t, uint16_t>, uint32_t> peers_;  // host's address and port
};

}  // namespace openr_host
