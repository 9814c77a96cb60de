// Base64 (RFC 4648, section 4), in which files travel in JSON.
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace openr_host {

std::string ToBase64(std::string_view bytes);

// Returns the bytes; none if `text` is not whole Base64 with its padding.
std::optional<std::string> FromBase64(std::string_view text);

}  // namespace openr_host
