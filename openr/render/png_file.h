#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace openr_host::render {

// Returns the bytes of a PNG file.  `rgb` has the pixels: three bytes each (red, green, blue), row
// by row, the top row first.  Throws std::runtime_error if libpng reports an error.
std::string EncodePng(int width, int height, const std::vector<uint8_t>& rgb);

}  // namespace openr_host::render
