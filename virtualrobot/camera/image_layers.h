// Converts a picture to the four layers H, M, L and C of an image vector (robot.md, 11).
//
// In each direction, layer H has half the sensor's pixels, layer M has half the pixels of H, and
// layer L has half the pixels of M.  Each of these three layers has six bands, interleaved row by
// row: Y (luminance), Cr, Cb, LH, HL and HH.  Programs use LH, HL and HH to compute Y in twice the
// resolution.  One pixel of a layer stands for a square of four pixels of the next larger layer (in
// case of layer H, of the picture).  Let a and b be the luminances of the upper two of these
// pixels, c and d those of the lower two.  LH, HL and HH are offset by 128:
//
//   Y = (a+b+c+d)/4   LH = (a+b-c-d)/4   HL = (a-b+c-d)/4   HH = (a-b-c+d)/4
//
// Cr = R - Y and Cb = B - Y, offset by 128 and limited to 0 to 255.  Programs compute the colour
// from them:
//
//   R = Y + Cr   G = Y - 0.51 Cr - 0.19 Cb   B = Y + Cb
//
// Layer C has the size of M; each of its pixels is a byte that says which colours were detected in
// M (colour_tables.h).
#pragma once

#include <OPENR/ODataFormats.h>

#include <array>
#include <cstdint>
#include <vector>

#include "virtualrobot/camera/colour_tables.h"
#include "virtualrobot/camera/image_source.h"

namespace openr_host {

// A table for each colour channel (red, green, blue) that maps a value of the source's picture to
// the value in the image that the robot sends: exposure[channel][picture value].
using Exposure = std::array<std::array<uint8_t, 256>, 3>;

class ImageLayers {
 public:
  // `width` and `height` are the size of the sensor in pixels.  REQUIRES: both are multiples of 8,
  // and `width` is at least 64, because Make() writes a tag of 16 bytes into a row of layer C,
  // which has only `width` / 4 bytes.
  ImageLayers(int width, int height);

  static constexpr size_t kBands = 6;
  static constexpr int kTagBytes = 16;         // size of a layer's tag: image number and counts
  size_t BytesOf(OFbkImageLayer layer) const;  // number of bytes of the layer's data
  int WidthOf(OFbkImageLayer layer) const;
  int HeightOf(OFbkImageLayer layer) const;

  // Fills in the data of all layers of `vector`.  In each layer, the last row begins with a tag
  // (field counter and pixel counts of the colours) instead of pixels.  In a layer with bands, only
  // the Y band has the tag.  REQUIRES: `picture` has the size of the sensor; the OFbkImageInfo of
  // each layer in `vector` is filled in.
  void Make(const Picture& picture, const Exposure& exposure, const ColourTables& tables,
            word field_counter, OFbkImageVectorData* vector);

 private:
  // Returns the number of bytes in one row of the layer `layer` of an image, with all bands.
  size_t BytesOfRow(OFbkImageLayer layer) const;
  void ReadPicture(const Picture& picture, const Exposure& exposure, byte* layer_h);
  // Computes Y, LH, HL and HH of `layer` into `to` from the luminance `from`, which has twice the
  // width and height; its rows are `row_bytes` apart.
  void SplitLuminance(const byte* from, size_t row_bytes, OFbkImageLayer layer, byte* to) const;
  // Computes Cr and Cb of `layer` into `to` from the layer `from`, which has twice the width and
  // height.
  void HalveColour(const byte* from, OFbkImageLayer layer, byte* to) const;
  // Computes layer C (the detected colours) from layer M (the image in medium resolution), and
  // counts into `counts` the pixels in which each channel was detected.
  void DetectColours(const byte* layer_m, const ColourTables& tables, byte* layer_c,
                     std::array<int, ocdtNUM_CHANNELS>* counts) const;

  const int width_, height_;  // size of the camera's sensor in pixels
  std::vector<byte> luminance_;
};

}  // namespace openr_host
