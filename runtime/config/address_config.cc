#include "runtime/config/address_config.h"

#include <fmt/format.h>

#include <algorithm>
#include <optional>

#include "runtime/base/parse_ip_address.h"
#include "runtime/config/line_file.h"

namespace openr_host {
namespace {

constexpr char kAddressForm[] = "write ROBOT=HOST, such as 10.0.1.2=127.0.0.1";

// Returns true if `ip` cannot be the address of a single computer, because it is 0.0.0.0 or a
// multicast, reserved or broadcast address.
bool IsNoHostAddress(uint32_t ip) { return ip == 0 || ip >> 28 >= 0xe; }

// Parses the texts of two addresses into `pair`.  Returns "" or the reason why one of the texts is
// no address.
std::string ReadPair(std::string_view robot, std::string_view host, AddressPair* pair) {
  for (const auto& [text, ip] : {std::pair{robot, &pair->robot}, std::pair{host, &pair->host}}) {
    const std::optional<uint32_t> address = ParseIpAddress(text);
    if (!address) {
      return fmt::format(
          "'{}' is no address; write four numbers of 0 to 255 with dots between them, such as "
          "10.0.1.2 (names are not looked up)",
          text);
    }
    *ip = *address;
    if (IsNoHostAddress(*address))
      return fmt::format("'{}' is no address of one computer, but of any, many or all", text);
  }
  if (pair->robot >> 24 == 127) {
    return fmt::format(
        "'{}' cannot stand for another address: programs mean the robot itself with it, or this "
        "computer",
        robot);
  }
  return "";
}

}  // namespace

std::string AddressText(uint32_t ip) {
  return fmt::format("{}.{}.{}.{}", ip >> 24, ip >> 16 & 255, ip >> 8 & 255, ip & 255);
}

std::string ParseAddressPair(std::string_view text, AddressPair* pair) {
  const size_t at = text.find('=');
  if (at == std::string_view::npos)
    return fmt::format("'{}' is no pair of addresses; {}", text, kAddressForm);
  const std::string problem = ReadPair(text.substr(0, at), text.substr(at + 1), pair);
  return problem.empty() ? "" : fmt::format("{}; {}", problem, kAddressForm);
}

std::string AddAddressPair(const AddressPair& pair, std::vector<AddressPair>* pairs) {
  for (const AddressPair& known : *pairs) {
    if (known.robot != pair.robot) continue;
    return fmt::format("{} stands for {} already", AddressText(pair.robot),
                       AddressText(known.host));
  }
  pairs->push_back(pair);
  return "";
}

AddressConfig ParseAddressConfig(const std::string& file, std::string_view text,
                                 std::string_view design) {
  AddressConfig config;
  for (const RecordLine& line : ReadRecords(file, text, design, &config.diagnostics)) {
    AddressPair pair;
    std::string problem =
        line.words.size() == 2
            ? ReadPair(line.words[0].text, line.words[1].text, &pair)
            : "a line holds two addresses: what programs call it, and where it is";
    if (problem.empty()) problem = AddAddressPair(pair, &config.pairs);
    if (!problem.empty())
      config.diagnostics.push_back(ErrorAt(line.place, problem + "; the line is left out"));
  }
  return config;
}

std::vector<AddressPair> MergeAddressPairs(std::vector<AddressPair> first,
                                           const std::vector<AddressPair>& second) {
  for (const AddressPair& pair : second) AddAddressPair(pair, &first);
  return first;
}

}  // namespace openr_host
