// Addresses that programs have compiled in or in their files, and where they are on this computer.
//
// A program of the period knows its peers as 10.0.1.2 and itself as 10.0.1.100.  A pair says which
// address of today is meant: on the command line (openr run --ip ROBOT=HOST), or in the file
// HOSTADDR.CFG beside CONNECT.CFG, a line of two addresses each.  The robot ignores that file.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "runtime/config/diagnostic.h"

namespace openr_host {

inline constexpr char kAddressFile[] = "HOSTADDR.CFG";

// Order of the host: 10.0.1.2 is 0x0a000102.
struct AddressPair {
  uint32_t robot = 0;  // as programs call it
  uint32_t host = 0;   // where it is
  bool operator==(const AddressPair&) const = default;
};

struct AddressConfig {
  std::vector<AddressPair> pairs;  // in file order
  std::vector<Diagnostic> diagnostics;
};

// "10.0.1.2"
std::string AddressText(uint32_t ip);

// Takes "10.0.1.2=127.0.0.1"; returns "" or what is wrong with it.
std::string ParseAddressPair(std::string_view text, AddressPair* pair);

// Appends `pair`; returns "" or why it cannot hold beside those that are there.
std::string AddAddressPair(const AddressPair& pair, std::vector<AddressPair>* pairs);

// Reads the text of a HOSTADDR.CFG, one "ROBOT HOST" per line.  `design`: the model whose sections
// count ("ERS-210").  A bad line is reported and skipped.
AddressConfig ParseAddressConfig(const std::string& file, std::string_view text,
                                 std::string_view design);

// `first`, and those of `second` whose robot's address is not in it.
std::vector<AddressPair> MergeAddressPairs(std::vector<AddressPair> first,
                                           const std::vector<AddressPair>& second);

}  // namespace openr_host
