#pragma once

#include <cstdint>
#include <vector>

#include "openr/render/scene.h"

namespace openr_host::render {

// Draws a scene off screen with Mesa and returns rows of red, green, blue, the top row first.
// Throws std::runtime_error when this machine's OpenGL cannot do it.
std::vector<uint8_t> Draw(const Scene& scene, int width_px, int height_px);

}  // namespace openr_host::render
