// Reads IPv4 addresses as programs of the robot and configuration files have them: "192.168.0.1".
#pragma once

#include <cstdint>
#include <optional>
#include <string_view>

namespace openr_host {

// Parses four numbers of 0 to 255 with dots between them, each with one to three digits.  Returns
// the address with the first number in the highest byte, so "10.0.1.2" is 0x0a000102.  Returns
// nullopt if `text` is anything else.
std::optional<uint32_t> ParseIpAddress(std::string_view text);

}  // namespace openr_host
