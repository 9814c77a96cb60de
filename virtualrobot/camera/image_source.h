// What the camera sees: a test pattern, files, memory.  The seam to a rendered world.
#pragma once

#include <Eigen/Geometry>
#include <cstdint>
#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace openr_host {

// Red, green, blue, 8 bits each, row by row from the top left.
struct Picture {
  int width = 0, height = 0;
  std::vector<uint8_t> rgb;

  uint8_t* At(int x, int y) {
    return &rgb[(static_cast<size_t>(y) * static_cast<size_t>(width) + static_cast<size_t>(x)) * 3];
  }
};

// When and from where a picture is taken.
struct CameraShot {
  int64_t number = 0;  // of the image since boot, from 1
  int64_t frame = 0;   // of 8 ms, since boot; sensors of the same frame belong to it
  // Of the lens in the world: x along the optical axis, y to the left, z up.
  Eigen::Isometry3d X_WC = Eigen::Isometry3d::Identity();
  double fov_h_rad = 0, fov_v_rad = 0;
};

class ImageSource {
 public:
  virtual ~ImageSource() = default;

  // Fills `picture`, which has the size of the camera's sensor (ERS-210: 352 x 288).
  // Empty, or why there is no picture; then `picture` is as it was.
  virtual std::string Capture(const CameraShot& shot, Picture* picture) = 0;
};

// Eight colour bars over a wedge of greys, a pink ball that moves, and the number of the
// image as 16 black and white cells along the top, highest bit first.  All in integers:
// the same on every machine.
class TestPattern : public ImageSource {
 public:
  std::string Capture(const CameraShot& shot, Picture* picture) override;

 private:
  Picture still_;  // all but ball and number
};

// The same pictures again and again, in order; one of another size is scaled.
class MemoryImageSource : public ImageSource {
 public:
  // REQUIRES: at least one.
  explicit MemoryImageSource(std::vector<Picture> pictures) : pictures_(std::move(pictures)) {}
  std::string Capture(const CameraShot& shot, Picture* picture) override;

 private:
  const std::vector<Picture> pictures_;
};

// The .png and .ppm files of a folder, in the order of their names, one an image, from the
// first again after the last.  Throws std::runtime_error when there are none.
std::unique_ptr<ImageSource> OpenImageFolder(const std::string& folder);

// Reads a PNG or a PPM (P6) file.  Throws std::runtime_error naming the file.
Picture ReadPicture(const std::string& file);

// Nearest pixels of `from`, in the size that `to` has.
void ScalePicture(const Picture& from, Picture* to);

}  // namespace openr_host
