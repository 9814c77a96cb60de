// openr_render_picture(), which draws a scene as a PNG file.  This function is the only function of
// libopenr_render.so that the program calls (scene.h).
#include <exception>

#include "openr/render/png_file.h"
#include "openr/render/renderer.h"
#include "openr/render/scene.h"

namespace openr_host::render {

extern "C" __attribute__((visibility("default"))) void openr_render_picture(const Scene& scene,
                                                                            const Picture& picture,
                                                                            std::string* png,
                                                                            std::string* error) {
  try {
    *png = EncodePng(picture.width_px, picture.height_px,
                     Draw(scene, picture.width_px, picture.height_px));
  } catch (const std::exception& e) {
    *error = e.what();
  }
}

}  // namespace openr_host::render
