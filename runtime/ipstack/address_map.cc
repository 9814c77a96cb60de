#include "runtime/ipstack/address_map.h"

#include <algorithm>

namespace openr_host {

bool AddressMap::Has(uint32_t robot) const {
  return std::any_of(pairs_.begin(), pairs_.end(),
                     [robot](const AddressPair& pair) { return pair.robot == robot; });
}

uint32_t AddressMap::ToHost(uint32_t address) const {
  for (const AddressPair& pair : pairs_)
    if (pair.robot == address) return pair.host;
  return address;
}

NetAddress AddressMap::ToHost(NetAddress peer) {
  const NetAddress host{ToHost(peer.ip), peer.port};
  if (!Has(peer.ip)) return host;
  // When peers_ (the addresses that programs have used for peers) is full, clears it, because a
  // program that scans ports would let peers_ grow without limit.
  if (peers_.size() >= kPeersMax) peers_.clear();
  peers_[{host.ip, host.port}] = peer.ip;
  return host;
}

NetAddress AddressMap::FromHost(NetAddress host) const {
  if (const auto peer = peers_.find({host.ip, host.port}); peer != peers_.end())
    return {peer->second, host.port};
  for (const AddressPair& pair : pairs_)
    if (pair.host == host.ip) return {pair.robot, host.port};
  return host;
}

}  // namespace openr_host
