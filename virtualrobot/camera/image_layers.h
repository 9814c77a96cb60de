// From a picture to the four layers of an image vector (robot.md, 11).
//
// Layer H has half the sensor's pixels in each direction, M half of H's, L half of M's.
// Bands are interleaved row by row: Y, Cr, Cb, and the three bands that double the
// resolution of Y, LH, HL, HH.  With a b / c d the four pixels that one pixel of Y stands
// for, and each high band offset by 128:
//
//   Y = (a+b+c+d)/4   LH = (a+b-c-d)/4   HL = (a-b+c-d)/4   HH = (a-b-c+d)/4
//
// Cr = R - Y and Cb = B - Y, offset by 128 and cut off at 0 and 255: what programs undo
// with R = Y + Cr, G = Y - 0.51 Cr - 0.19 Cb, B = Y + Cb.
#pragma once

#include <OPENR/ODataFormats.h>

#include <array>
#include <cstdint>
#include <vector>

#include "virtualrobot/camera/colour_tables.h"
#include "virtualrobot/camera/image_source.h"

namespace openr_host {

// How bright each colour of the picture comes out: [red, green, blue][value].
using Exposure = std::array<std::array<uint8_t, 256>, 3>;

class ImageLayers {
 public:
  // REQUIRES: width and height are multiples of 8; layer C is at least as wide as a tag (16).
  ImageLayers(int width, int height);

  static constexpr size_t kBands = 6;
  size_t BytesOf(OFbkImageLayer layer) const;  // of its data
  int WidthOf(OFbkImageLayer layer) const;
  int HeightOf(OFbkImageLayer layer) const;

  // Fills the data of all layers of `vector`, whose infos are filled in.  The last row of each
  // layer, of its Y band where it has one, begins with the tag instead of pixels.
  void Make(const Picture& picture, const Exposure& exposure, const ColourTables& tables,
            word field_counter, OFbkImageVectorData* vector);

 private:
  size_t BytesOfRow(OFbkImageLayer layer) const;  // of all its bands
  void ReadPicture(const Picture& picture, const Exposure& exposure, byte* layer_h);
  // Y and the high bands of a layer from luminance of twice its size.
  void SplitLuminance(const byte* from, size_t row_bytes, OFbkImageLayer layer, byte* to) const;
  // Cr and Cb of a layer from those of the layer above.
  void HalveColour(const byte* from, OFbkImageLayer layer, byte* to) const;
  // Layer C from layer M; counts the pixels of each channel.
  void DetectColours(const byte* layer_m, const ColourTables& tables, byte* layer_c,
                     std::array<int, ocdtNUM_CHANNELS>* counts) const;

  const int width_, height_;  // of the sensor
  std::vector<byte> luminance_;
};

}  // namespace openr_host
