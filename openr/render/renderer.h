#pragma once

#include <cstdint>
#include <vector>

#include "openr/render/scene.h"

namespace openr_host::render {

// Draws `scene` into memory, without a screen.  Returns three bytes (red, green, blue) for each
// pixel, row by row, the top row first.  Throws std::runtime_error when the drawing fails in Mesa,
// the graphics library that draws without a graphics card.
std::vector<uint8_t> Draw(const Scene& scene, int width_px, int height_px);

}  // namespace openr_host::render
