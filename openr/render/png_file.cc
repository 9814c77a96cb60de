#include "openr/render/png_file.h"

#include <png.h>

#include <cerrno>
#include <cstdio>
#include <cstring>

namespace openr_host::render {

std::string WritePng(const std::string& file, int width, int height,
                     const std::vector<uint8_t>& rgb) {
  png_image image;
  std::memset(&image, 0, sizeof image);
  image.version = PNG_IMAGE_VERSION;
  image.width = static_cast<png_uint_32>(width);
  image.height = static_cast<png_uint_32>(height);
  image.format = PNG_FORMAT_RGB;
  errno = 0;
  if (png_image_write_to_file(&image, file.c_str(), 0, rgb.data(), 0, nullptr) != 0) return "";
  const std::string why = errno != 0 ? std::strerror(errno) : image.message;
  std::remove(file.c_str());
  return file + ": cannot be written: " + why;
}

}  // namespace openr_host::render
