#include "openr/render/png_file.h"

#include <png.h>

#include <cstring>
#include <stdexcept>

namespace openr_host::render {

std::string EncodePng(int width, int height, const std::vector<uint8_t>& rgb) {
  png_image image;
  std::memset(&image, 0, sizeof image);
  image.version = PNG_IMAGE_VERSION;
  image.width = static_cast<png_uint_32>(width);
  image.height = static_cast<png_uint_32>(height);
  image.format = PNG_FORMAT_RGB;
  png_alloc_size_t size = PNG_IMAGE_PNG_SIZE_MAX(image);
  std::string png(size, '\0');
  if (png_image_write_to_memory(&image, png.data(), &size, 0, rgb.data(), 0, nullptr) == 0)
    throw std::runtime_error(std::string("no PNG can be made: ") + image.message);
  png.resize(size);
  return png;
}

}  // namespace openr_host::render
