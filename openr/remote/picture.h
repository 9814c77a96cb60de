// Picture, a picture that the robot's camera has taken.
#pragma once

#include <cstdint>
#include <string>

namespace openr::remote {

// A picture in one of the camera's layers.  Layers H, M and L have six bands, interleaved row by
// row: a row of Y, then of Cr, of Cb and of three more bands, then the next row of each band.
// Layer C has one band, the detected colours.
struct Picture {
  uint32_t frame = 0;  // number of the frame of 8 ms in which the picture was taken
  int layer = 0;       // number of the layer: 0 H, 1 M, 2 L, 3 C
  int bands = 0;
  int width = 0;  // width in pixels
  int height = 0;
  std::string bytes;

  // Returns red, green and blue of each pixel, row by row from the top left.  Throws
  // std::runtime_error if bytes are missing, or if the picture is of layer C, because this layer
  // has no bands for brightness and colour.
  std::string Rgb() const;

  // Returns the picture as the bytes of a file: .ppm (P6), or .pgm (P5) for layer C.  Throws
  // std::runtime_error if bytes are missing.
  std::string File() const;
};

}  // namespace openr::remote
