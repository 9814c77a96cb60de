// Converts a picture to the four layers of an image vector (robot.md, 11).
//
// Layer H has half the sensor's pixels in each direction, M half of H's, L half of M's.
// Each has six bands, interleaved row by row: Y, Cr, Cb, and LH, HL, HH, from which programs
// compute Y in twice the resolution.  One pixel of Y stands for four pixels of the picture, a and b
// above c and d.  Each of the last three bands is offset by 128:
//
//   Y = (a+b+c+d)/4   LH = (a+b-c-d)/4   HL = (a-b+c-d)/4   HH = (a-b-c+d)/4
//
// Cr = R - Y and Cb = B - Y, offset by 128 and cut off at 0 and 255.  Programs compute
// R = Y + Cr, G = Y - 0.51 Cr - 0.19 Cb, B = Y + Cb.  Layer C has the colours that were detected in
// M.
#pragma once

#include <OPENR/ODataFormats.h>

#include <array>
#include <cstdint>
#include <vector>

#include "virtualrobot/camera/colour_tables.h"
#include "virtualrobot/camera/image_source.h"

namespace openr_host {

// Maps the values of a picture to those of the image: [red, green, blue][value].
using Exposure = std::array<std::array<uint8_t, 256>, 3>;

class ImageLayers {
 public:
  // REQUIRES: width and height are multiples of 8; layer C is at least as wide as a tag (16).
  ImageLayers(int width, int height);

  static constexpr size_t kBands = 6;
  size_t BytesOf(OFbkImageLayer layer) const;  // size of the data of a layer
  int WidthOf(OFbkImageLayer layer) const;
  int HeightOf(OFbkImageLayer layer) const;

  // Fills in the data of all layers of `vector`.  The last row of each layer (of the Y band, if
  // there is one) begins with the tag instead of pixels.  REQUIRES: `picture` has the size of the
  // sensor; the infos of `vector` are filled in.
  void Make(const Picture& picture, const Exposure& exposure, const ColourTables& tables,
            word field_counter, OFbkImageVectorData* vector);

 private:
  size_t BytesOfRow(OFbkImageLayer layer) const;  // all bands together
  void ReadPicture(const Picture& picture, const Exposure& exposure, byte* layer_h);
  // Computes Y, LH, HL and HH of a layer from luminance of twice the size.
  void SplitLuminance(const byte* from, size_t row_bytes, OFbkImageLayer layer, byte* to) const;
  // Computes Cr and Cb of a layer from those of the layer with twice the size.
  void HalveColour(const byte* from, OFbkImageLayer layer, byte* to) const;
  // Computes layer C from layer M, and counts the pixels of each channel.
  void DetectColours(const byte* layer_m, const ColourTables& tables, byte* layer_c,
                     std::array<int, ocdtNUM_CHANNELS>* counts) const;

  const int width_, height_;  // size of the sensor, pixels
  std::vector<byte> luminance_;
};

}  // namespace openr_host
