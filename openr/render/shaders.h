// Shaders in GLSL 1.20.  The two depth shaders draw the distance of the nearest surfaces from a
// light. The two picture shaders draw the picture, and use these distances to find the points in
// shadow.
#pragma once

namespace openr_host::render {

extern const char kDepthVertexShader[];
extern const char kDepthFragmentShader[];
extern const char kPictureVertexShader[];
extern const char kPictureFragmentShader[];

}  // namespace openr_host::render
