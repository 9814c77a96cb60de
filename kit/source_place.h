// From a position in a source to what a person is shown of it.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

#include "runtime/config/diagnostic.h"

namespace openr_host {

// The line and column of `offset` in `text`, which is that of `file`.
FilePosition PlaceAt(const std::string& file, std::string_view text, size_t offset);

}  // namespace openr_host
