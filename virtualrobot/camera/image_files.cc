// Reads pictures from files: PNG with libpng, PPM with our own code.
#include <fmt/format.h>
#include <png.h>

#include <algorithm>
#include <cstring>
#include <filesystem>
#include <stdexcept>
#include <utility>

#include "runtime/base/read_file.h"
#include "virtualrobot/camera/image_source.h"

namespace openr_host {
namespace {

constexpr int kSideMax = 8192;  // largest width and height of a picture, in pixels

[[noreturn]] void Fail(const std::string& file, const std::string& why) {
  throw std::runtime_error(file + ": " + why);
}

Picture Empty(int width, int height) {
  return {width, height,
          std::vector<uint8_t>(static_cast<size_t>(width) * static_cast<size_t>(height) * 3)};
}

Picture ReadPng(const std::string& bytes, const std::string& file) {
  png_image image;
  std::memset(&image, 0, sizeof image);
  image.version = PNG_IMAGE_VERSION;
  if (png_image_begin_read_from_memory(&image, bytes.data(), bytes.size()) == 0)
    Fail(file, fmt::format("no PNG file: {}", image.message));
  if (image.width > kSideMax || image.height > kSideMax) {
    // Frees libpng's memory here, because png_image_finish_read(), which frees it otherwise, is not
    // called.
    png_image_free(&image);
    Fail(file, fmt::format("more than {} pixels wide or high", kSideMax));
  }
  image.format = PNG_FORMAT_RGB;
  Picture picture = Empty(static_cast<int>(image.width), static_cast<int>(image.height));
  const png_color black = {0, 0, 0};  // colour behind transparent pixels
  if (png_image_finish_read(&image, &black, picture.rgb.data(), 0, nullptr) == 0)
    Fail(file, fmt::format("cannot be read: {}", image.message));
  return picture;
}

// Reads the next number of a PPM header.  Begins at position `*at` of `bytes`, skips blanks and
// comments, returns the number after them, and moves `*at` to the end of this number.  Throws
// std::runtime_error with the name `file` if no number from 1 to `limit` follows.
int HeaderNumber(const std::string& bytes, int limit, size_t* at, const std::string& file) {
  while (*at < bytes.size() && std::strchr(" \t\r\n#", bytes[*at]) != nullptr) {
    if (bytes[*at] == '#') *at = std::min(bytes.find('\n', *at), bytes.size() - 1);
    ++*at;
  }
  int number = 0;
  const size_t begin = *at;
  for (; *at < bytes.size() && bytes[*at] >= '0' && bytes[*at] <= '9'; ++*at) {
    number = number * 10 + (bytes[*at] - '0');
    // Reads no more digits when the number exceeds the limit, because more digits could make the
    // number overflow.
    if (number > limit) break;
  }
  if (*at == begin || number < 1 || number > limit)
    Fail(file, fmt::format("PPM header: a number from 1 to {} is missing", limit));
  return number;
}

Picture ReadPpm(const std::string& bytes, const std::string& file) {
  size_t at = 2;
  const int width = HeaderNumber(bytes, kSideMax, &at, file);
  const int height = HeaderNumber(bytes, kSideMax, &at, file);
  const int max = HeaderNumber(bytes, 65535, &at, file);
  if (max != 255) Fail(file, fmt::format("PPM with values up to {}; only 255 is read", max));
  ++at;  // skips the one blank character that ends a PPM header
  // Checks the number of bytes before memory for the picture is allocated, because a short file may
  // name a size that needs much memory.
  const size_t needed = size_t{3} * static_cast<size_t>(width) * static_cast<size_t>(height);
  const size_t found = bytes.size() - std::min(at, bytes.size());
  if (found < needed) {
    Fail(file, fmt::format("is cut off: {} bytes of pixels, {} x {} need {}", found, width, height,
                           needed));
  }
  Picture picture = Empty(width, height);
  std::memcpy(picture.rgb.data(), bytes.data() + at, picture.rgb.size());
  return picture;
}

class ImageFolder : public ImageSource {
 public:
  explicit ImageFolder(const std::string& folder) {
    std::error_code error;
    for (const auto& entry : std::filesystem::directory_iterator(folder, error)) {
      const std::string extension = entry.path().extension().string();
      if (extension == ".png" || extension == ".ppm") files_.push_back(entry.path().string());
    }
    if (error) Fail(folder, "cannot be read: " + error.message());
    if (files_.empty()) Fail(folder, "holds no .png and no .ppm file");
    // Sorts the files, because a folder lists them in an order that differs between machines.
    std::sort(files_.begin(), files_.end());
  }

  std::string Capture(const CameraShot& shot, Picture* picture) override {
    const size_t index = static_cast<size_t>(shot.number - 1) % files_.size();
    try {
      ScalePicture(ReadPicture(files_[index]), picture);
    } catch (const std::runtime_error& problem) {
      return problem.what();
    }
    return "";
  }

 private:
  std::vector<std::string> files_;
};

}  // namespace

Picture ReadPicture(const std::string& file) {
  const std::string bytes = ReadFileOrThrow(file);
  if (bytes.starts_with("\x89PNG")) return ReadPng(bytes, file);
  if (bytes.starts_with("P6")) return ReadPpm(bytes, file);
  Fail(file, "is neither a PNG nor a PPM (P6) file");
}

std::unique_ptr<ImageSource> OpenImageFolder(const std::string& folder) {
  return std::make_unique<ImageFolder>(folder);
}

}  // namespace openr_host
