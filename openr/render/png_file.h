#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace openr_host::render {

// Returns a PNG file with the pixels `rgb`: rows of red, green, blue, the top row first, 3 * width
// * height bytes.  Throws std::runtime_error.
std::string EncodePng(int width, int height, const std::vector<uint8_t>& rgb);

}  // namespace openr_host::render
