// Shaders in GLSL 1.20 for the two passes: distances from a light, and the picture.
#pragma once

namespace openr_host::render {

extern const char kDepthVertexShader[];
extern const char kDepthFragmentShader[];
extern const char kPictureVertexShader[];
extern const char kPictureFragmentShader[];

}  // namespace openr_host::render
