#include "runtime/base/parse_ip_address.h"

#include <charconv>
#include <system_error>

namespace openr_host {

std::optional<uint32_t> ParseIpAddress(std::string_view text) {
  const char* at = text.data();
  const char* const end = at + text.size();
  uint32_t address = 0;
  for (int i = 0; i < 4; ++i) {
    if (i > 0 && (at == end || *at++ != '.')) return std::nullopt;
    unsigned number = 0;
    const auto [rest, error] = std::from_chars(at, end, number);
    if (error != std::errc() || rest - at > 3 || number > 255) return std::nullopt;
    address = address << 8 | number;
    at = rest;
  }
  if (at != end) return std::nullopt;
  return address;
}

}  // namespace openr_host
