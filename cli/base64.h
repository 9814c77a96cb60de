// Base64 (RFC 4648, section 4), the encoding of files in JSON messages.
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace openr_host {

std::string ToBase64(std::string_view bytes);

// Returns the decoded bytes; nullopt if `text` is not complete Base64 with its padding.
std::optional<std::string> FromBase64(std::string_view text);

}  // namespace openr_host
