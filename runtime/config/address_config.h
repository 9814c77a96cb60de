// Replaces fixed IP addresses in old programs by addresses of today's network.
//
// A program for the robot often contains fixed addresses that no longer exist, such as 10.0.1.2 for
// a PC.  A pair of addresses consists of an old address and the address that the host uses in its
// place.  Pairs come from the command line (openr run --ip ROBOT=HOST) and from the file
// HOSTADDR.CFG beside CONNECT.CFG, which has one pair per line.  The robot ignores HOSTADDR.CFG.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "runtime/config/diagnostic.h"

namespace openr_host {

inline constexpr char kAddressFile[] = "HOSTADDR.CFG";

// A pair of IPv4 addresses in the host's byte order: 10.0.1.2 is 0x0a000102.
struct AddressPair {
  uint32_t robot = 0;  // the address that programs use
  uint32_t host = 0;   // the address that the host uses in place of `robot`
  bool operator==(const AddressPair&) const = default;
};

struct AddressConfig {
  std::vector<AddressPair> pairs;  // in the order of the file
  std::vector<Diagnostic> diagnostics;
};

// Returns an address as text, such as "10.0.1.2" for 0x0a000102.
std::string AddressText(uint32_t ip);

// Parses a pair of addresses such as "10.0.1.2=127.0.0.1" into `*pair`.  Returns "" or the reason
// why `text` is invalid.
std::string ParseAddressPair(std::string_view text, AddressPair* pair);

// Appends `pair` to `pairs` and returns "".  If the robot address of `pair` is in `pairs` already,
// returns an error text.
std::string AddAddressPair(const AddressPair& pair, std::vector<AddressPair>* pairs);

// Parses the text of a HOSTADDR.CFG, one pair of addresses "ROBOT HOST" per line.  `design` is the
// robot design ("ERS-210") for which lines are read.  A bad line is reported and skipped.
AddressConfig ParseAddressConfig(const std::string& file, std::string_view text,
                                 std::string_view design);

// Returns the pairs of `first`, and those pairs of `second` whose robot address is not in `first`.
// Called with the pairs of the command line as `first`, because they take precedence over the pairs
// of the file HOSTADDR.CFG.
std::vector<AddressPair> MergeAddressPairs(std::vector<AddressPair> first,
                                           const std::vector<AddressPair>& second);

}  // namespace openr_host
