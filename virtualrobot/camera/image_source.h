// Sources of the pictures that the camera takes: a test pattern, files, or pictures in memory.
// RenderedWorld (rendered_world.h) draws the robot's world.
#pragma once

#include <Eigen/Geometry>
#include <cstdint>
#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace openr_host {

class Body;

// A picture with 8 bits each for red, green and blue, row by row from the top left.
struct Picture {
  int width = 0, height = 0;
  std::vector<uint8_t> rgb;

  uint8_t* At(int x, int y) {
    return &rgb[(static_cast<size_t>(y) * static_cast<size_t>(width) + static_cast<size_t>(x)) * 3];
  }
};

// The time and the place at which a picture is taken.
struct CameraShot {
  int64_t number = 0;  // number of the image since boot, from 1
  int64_t frame = 0;   // frame in which the image was taken; its sensor samples belong to the image
  // Pose of the lens in the world W, with x along the optical axis, y to the left and z up.
  Eigen::Isometry3d X_WC = Eigen::Isometry3d::Identity();
  double fov_h_rad = 0, fov_v_rad = 0;
  // The body that carries the camera.  Sources that draw the robot's world need it; it is null in
  // some tests.
  const Body* body = nullptr;
};

class ImageSource {
 public:
  virtual ~ImageSource() = default;

  // Fills `picture`, which already has the size of the camera's sensor (ERS-210: 352 x 288 pixels).
  // Returns "", or the reason why there is no picture; then `picture` is unchanged.
  virtual std::string Capture(const CameraShot& shot, Picture* picture) = 0;
};

// The test pattern: eight colour bars above a grey scale, a pink ball that moves, and the number of
// the image as 16 black and white cells along the top, highest bit first.  Because the pattern is
// computed with integers, it is the same on every machine.
class TestPattern : public ImageSource {
 public:
  std::string Capture(const CameraShot& shot, Picture* picture) override;

 private:
  Picture still_;  // the test pattern without its ball and the image's number
};

// Shows the given pictures in order, again and again.  A picture of another size than the sensor is
// scaled.
class MemoryImageSource : public ImageSource {
 public:
  // Makes a source that shows `pictures`.  REQUIRES: `pictures` is not empty.
  explicit MemoryImageSource(std::vector<Picture> pictures);
  std::string Capture(const CameraShot& shot, Picture* picture) override;

 private:
  const std::vector<Picture> pictures_;
};

// Opens a source that shows the .png and .ppm files of `folder` in the order of their names, one
// file for each image.  After the last file it starts again with the first.  Throws
// std::runtime_error when the folder cannot be read or has no such file.
std::unique_ptr<ImageSource> OpenImageFolder(const std::string& folder);

// Reads a PNG or PPM (P6) file.  Throws std::runtime_error that names the file and says what is
// wrong with it.
Picture ReadPicture(const std::string& file);

// Scales `from` to the size that `to` has; each pixel of `to` is a copy of the nearest pixel of
// `from`.
void ScalePicture(const Picture& from, Picture* to);

}  // namespace openr_host
