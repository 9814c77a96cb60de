// Shaders in GLSL 1.20.  The two depth shaders draw distances from a light; the two picture shaders
// draw the picture.
#pragma once

namespace openr_host::render {

extern const char kDepthVertexShader[];
extern const char kDepthFragmentShader[];
extern const char kPictureVertexShader[];
extern const char kPictureFragmentShader[];

}  // namespace openr_host::render
