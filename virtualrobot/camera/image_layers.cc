#include "virtualrobot/camera/image_layers.h"

#include <algorithm>

#include "runtime/base/assert.h"

namespace openr_host {
namespace {

constexpr int kFrequencyUnit = 16;  // WriteTag() counts the pixels of a colour in units of 16
constexpr OFbkImageLayer kColourLayers[] = {ofbkimageLAYER_H, ofbkimageLAYER_M, ofbkimageLAYER_L};

byte Offset(int value) { return static_cast<byte>(std::clamp(value + 128, 0, 255)); }

// Returns the luminance of a colour.  The weights fit the formula by which programs compute green
// from Y, Cr and Cb (image_layers.h), so the result of this formula is the original green.
int Luminance(int r, int g, int b) { return (77 * r + 150 * g + 29 * b) >> 8; }

// Writes the tag of a layer: the bytes with which the last row of the layer begins.  Bytes 0 and 1
// are the field counter (number of the image).  Bytes 4 to 7 belong to the channels 4 to 7, and
// bytes 8 to 11 to the channels 0 to 3.  Each of these bytes is the number of pixels in which the
// channel was detected, in units of 16 pixels, at most 255.
void WriteTag(word field_counter, const std::array<int, ocdtNUM_CHANNELS>& counts, byte* tag) {
  std::fill_n(tag, ImageLayers::kTagBytes, byte{0});
  tag[0] = static_cast<byte>(field_counter & 0xff);
  tag[1] = static_cast<byte>(field_counter >> 8);
  for (size_t channel = 0; channel < ocdtNUM_CHANNELS; ++channel) {
    tag[channel < 4 ? 8 + channel : channel] =
        static_cast<byte>(std::min(counts[channel] / kFrequencyUnit, 255));
  }
}

}  // namespace

ImageLayers::ImageLayers(int width, int height) : width_(width), height_(height) {
  ASSERT(width % 8 == 0 && height % 8 == 0, "{} x {}", width, height);
  ASSERT(WidthOf(ofbkimageLAYER_C) >= ImageLayers::kTagBytes, "no room for the tag in {} pixels",
         width);
}

int ImageLayers::WidthOf(OFbkImageLayer layer) const {
  return layer == ofbkimageLAYER_C ? WidthOf(ofbkimageLAYER_M) : width_ >> (layer + 1);
}

int ImageLayers::HeightOf(OFbkImageLayer layer) const {
  return layer == ofbkimageLAYER_C ? HeightOf(ofbkimageLAYER_M) : height_ >> (layer + 1);
}

size_t ImageLayers::BytesOf(OFbkImageLayer layer) const {
  return BytesOfRow(layer) * static_cast<size_t>(HeightOf(layer));
}

size_t ImageLayers::BytesOfRow(OFbkImageLayer layer) const {
  const auto width = static_cast<size_t>(WidthOf(layer));
  return layer == ofbkimageLAYER_C ? width : kBands * width;
}

void ImageLayers::ReadPicture(const Picture& picture, const Exposure& exposure, byte* layer_h) {
  const auto width = static_cast<size_t>(width_);
  // Allocates the memory here and not in the constructor, because most robots never take a picture.
  luminance_.resize(width * static_cast<size_t>(height_));
  const size_t w = width / 2;
  // Goes through the picture in squares of four pixels, because the four pixels of a square have
  // four values of luminance but share one Cr and one Cb.
  for (size_t y = 0; y < static_cast<size_t>(height_); y += 2) {
    const uint8_t* rows[] = {&picture.rgb[y * width * 3], &picture.rgb[(y + 1) * width * 3]};
    byte* light[] = {&luminance_[y * width], &luminance_[(y + 1) * width]};
    byte* const cr = layer_h + (y / 2) * kBands * w + w;
    byte* const cb = cr + w;
    for (size_t x = 0; x < width; x += 2) {
      int red = 0, blue = 0, sum = 0;
      for (size_t i = 0; i < 4; ++i) {
        const uint8_t* const rgb = rows[i / 2] + (x + i % 2) * 3;
        const int r = exposure[0][rgb[0]], g = exposure[1][rgb[1]], b = exposure[2][rgb[2]];
        const int luminance = Luminance(r, g, b);
        light[i / 2][x + i % 2] = static_cast<byte>(luminance);
        red += r;
        blue += b;
        sum += luminance;
      }
      cr[x / 2] = Offset((red - sum) / 4);
      cb[x / 2] = Offset((blue - sum) / 4);
    }
  }
}

void ImageLayers::SplitLuminance(const byte* from, size_t row_bytes, OFbkImageLayer layer,
                                 byte* to) const {
  const auto w = static_cast<size_t>(WidthOf(layer));
  for (int y = 0; y < HeightOf(layer); ++y, from += 2 * row_bytes, to += kBands * w) {
    const byte* const below = from + row_bytes;
    for (size_t x = 0; x < w; ++x) {
      const int a = from[2 * x], b = from[2 * x + 1], c = below[2 * x], d = below[2 * x + 1];
      to[x] = static_cast<byte>((a + b + c + d) / 4);
      to[3 * w + x] = Offset((a + b - c - d) / 4);
      to[4 * w + x] = Offset((a - b + c - d) / 4);
      to[5 * w + x] = Offset((a - b - c + d) / 4);
    }
  }
}

void ImageLayers::HalveColour(const byte* from, OFbkImageLayer layer, byte* to) const {
  const auto w = static_cast<size_t>(WidthOf(layer));
  // Number of bytes of one row of the layer `from`, with all its bands.
  const size_t group = kBands * 2 * w;
  for (int y = 0; y < HeightOf(layer); ++y, from += 2 * group, to += kBands * w) {
    for (const size_t band : {1, 2}) {
      const byte* const row = from + band * 2 * w;
      const byte* const below = row + group;
      for (size_t x = 0; x < w; ++x) {
        to[band * w + x] =
            static_cast<byte>((row[2 * x] + row[2 * x + 1] + below[2 * x] + below[2 * x + 1]) / 4);
      }
    }
  }
}

void ImageLayers::DetectColours(const byte* layer_m, const ColourTables& tables, byte* layer_c,
                                std::array<int, ocdtNUM_CHANNELS>* counts) const {
  counts->fill(0);
  if (tables.empty()) {
    std::fill_n(layer_c, BytesOf(ofbkimageLAYER_C), byte{0});
    return;
  }
  std::array<int, 256> pixels{};  // pixels[bits]: number of pixels of layer C whose byte is `bits`
  const auto w = static_cast<size_t>(WidthOf(ofbkimageLAYER_M));
  for (int y = 0; y < HeightOf(ofbkimageLAYER_M); ++y, layer_m += kBands * w, layer_c += w) {
    for (size_t x = 0; x < w; ++x) {
      layer_c[x] = tables.Detect(layer_m[x], layer_m[w + x], layer_m[2 * w + x]);
      ++pixels[layer_c[x]];
    }
  }
  for (size_t bits = 1; bits < pixels.size(); ++bits) {
    for (size_t channel = 0; channel < ocdtNUM_CHANNELS; ++channel) {
      if (bits >> channel & 1) (*counts)[channel] += pixels[bits];
    }
  }
}

void ImageLayers::Make(const Picture& picture, const Exposure& exposure, const ColourTables& tables,
                       word field_counter, OFbkImageVectorData* vector) {
  ASSERT(picture.width == width_ && picture.height == height_, "{} x {}", picture.width,
         picture.height);
  const auto data = [&](OFbkImageLayer layer) { return vector->GetData(static_cast<int>(layer)); };
  ReadPicture(picture, exposure, data(ofbkimageLAYER_H));
  // Points to the luminance from which the next layer is made: first that of the picture, and then
  // that of the layer made last.
  const byte* light = luminance_.data();
  size_t row_bytes = static_cast<size_t>(width_);
  for (const OFbkImageLayer layer : kColourLayers) {
    if (layer != ofbkimageLAYER_H) HalveColour(data(layer - 1), layer, data(layer));
    SplitLuminance(light, row_bytes, layer, data(layer));
    light = data(layer);
    row_bytes = kBands * static_cast<size_t>(WidthOf(layer));
  }
  std::array<int, ocdtNUM_CHANNELS> counts;
  DetectColours(data(ofbkimageLAYER_M), tables, data(ofbkimageLAYER_C), &counts);
  for (OFbkImageLayer layer = 0; layer < ofbkimageNUM_LAYERS; ++layer) {
    const size_t rows_above = static_cast<size_t>(HeightOf(layer) - 1);
    WriteTag(field_counter, counts, data(layer) + rows_above * BytesOfRow(layer));
  }
}

}  // namespace openr_host
