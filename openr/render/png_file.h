#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace openr_host::render {

// Writes rows of red, green, blue, the top row first; `rgb` has 3 * width * height bytes.
// Returns "" or what went wrong; then no file is left behind.
std::string WritePng(const std::string& file, int width, int height,
                     const std::vector<uint8_t>& rgb);

}  // namespace openr_host::render
