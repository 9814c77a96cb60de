#include "openr/remote/address.h"

#include <fmt/format.h>

#include <charconv>

#include "openr/remote/error.h"

namespace openr::remote {

Address ParseAddress(const std::string& text) {
  Address address;
  const size_t colon = text.rfind(':');
  if (colon != text.find(':')) {
    throw Error(ErrorCode::kAddress, fmt::format("'{}' has more than one colon", text),
                "the network of a robot is IPv4, so there are no IPv6 addresses: write "
                "127.0.0.1:54000");
  }
  address.host = text.substr(0, colon);
  if (address.host.empty()) {
    throw Error(ErrorCode::kAddress, fmt::format("'{}' names no host", text),
                "write 127.0.0.1:54000");
  }
  if (colon == std::string::npos) return address;
  const char* const end = text.data() + text.size();
  const auto [stop, error] = std::from_chars(text.data() + colon + 1, end, address.port);
  if (error == std::errc() && stop == end && address.port != 0) return address;
  throw Error(ErrorCode::kAddress,
              fmt::format("'{}' has no port from 1 to 65535 after the colon", text));
}

}  // namespace openr::remote
