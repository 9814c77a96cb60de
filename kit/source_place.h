// Converts a position in a source to a line and a column, for messages.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

#include "runtime/config/diagnostic.h"

namespace openr_host {

// Returns the line and column of `offset` in `text`, the content of `file`.
FilePosition PlaceAt(const std::string& file, std::string_view text, size_t offset);

}  // namespace openr_host
