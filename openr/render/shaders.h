// Shaders in GLSL 1.20.  The two depth shaders draw how far the nearest surfaces are from a light.
// With these distances the two picture shaders, which draw the picture, find what is in shadow.
#pragma once

namespace openr_host::render {

extern const char kDepthVertexShader[];
extern const char kDepthFragmentShader[];
extern const char kPictureVertexShader[];
extern const char kPictureFragmentShader[];

}  // namespace openr_host::render
