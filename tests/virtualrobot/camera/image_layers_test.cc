// From pictures to layers: robot.md 11.
#include "virtualrobot/camera/image_layers.h"

#include <OPENR/OFbkImage.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cstring>

namespace openr_host {
namespace {

constexpr int kWidth = 64, kHeight = 48;

Exposure Plain() {
  Exposure exposure;
  for (auto& colour : exposure) {
    for (size_t value = 0; value < 256; ++value) colour[value] = static_cast<uint8_t>(value);
  }
  return exposure;
}

// A vector of the layers of one picture.
class Layers {
 public:
  explicit Layers(const Picture& picture, const ColourTables& tables = {}, word counter = 1,
                  const Exposure& exposure = Plain())
      : layers_(kWidth, kHeight), memory_(100'000) {
    auto* const vector = reinterpret_cast<OFbkImageVectorData*>(memory_.data());
    size_t offset = sizeof(ODataVectorInfo) + ofbkimageNUM_LAYERS * sizeof(OFbkImageInfo);
    for (OFbkImageLayer layer = 0; layer < ofbkimageNUM_LAYERS; ++layer) {
      OFbkImageInfo& info = *vector->GetInfo(static_cast<int>(layer));
      info.type = layer == ofbkimageLAYER_C ? odataFBK_CDT : odataFBK_YCrCb_HPF;
      info.dataOffset = static_cast<longword>(offset);
      info.width = static_cast<longword>(layers_.WidthOf(layer));
      info.height = static_cast<longword>(layers_.HeightOf(layer));
      offset += layers_.BytesOf(layer);
    }
    layers_.Make(picture, exposure, tables, counter, vector);
  }
  OFbkImage Band(OFbkImageLayer layer, OFbkImageBand band) {
    auto* const vector = reinterpret_cast<OFbkImageVectorData*>(memory_.data());
    return OFbkImage(vector->GetInfo(static_cast<int>(layer)),
                     vector->GetData(static_cast<int>(layer)), band);
  }

 private:
  ImageLayers layers_;
  std::vector<byte> memory_;
};

Picture Plain(uint8_t r, uint8_t g, uint8_t b) {
  Picture picture{kWidth, kHeight, {}};
  for (int i = 0; i < kWidth * kHeight; ++i) picture.rgb.insert(picture.rgb.end(), {r, g, b});
  return picture;
}

TEST(ImageLayersTest, EveryLayerIsHalfOfTheOneAboveAndColourDetectionIsOfTheSecond) {
  Layers layers(Plain(0, 0, 0));
  const int sizes[][2] = {{32, 24}, {16, 12}, {8, 6}};
  for (OFbkImageLayer layer = 0; layer < 3; ++layer) {
    EXPECT_EQ(layers.Band(layer, ofbkimageBAND_Y).Width(), sizes[layer][0]);
    EXPECT_EQ(layers.Band(layer, ofbkimageBAND_Y).Height(), sizes[layer][1]);
    EXPECT_EQ(layers.Band(layer, ofbkimageBAND_Y).Skip(), 5 * sizes[layer][0]);
  }
  EXPECT_EQ(layers.Band(ofbkimageLAYER_C, ofbkimageBAND_CDT).Width(), 16);
  EXPECT_EQ(layers.Band(ofbkimageLAYER_C, ofbkimageBAND_CDT).Skip(), 0);
}

TEST(ImageLayersTest, GreyHasNoColourAndAFlatPictureNoHighBands) {
  Layers layers(Plain(100, 100, 100));
  for (OFbkImageLayer layer = 0; layer < 3; ++layer) {
    EXPECT_EQ(layers.Band(layer, ofbkimageBAND_Y).Pixel(3, 3), 100);
    for (const OFbkImageBand band : {ofbkimageBAND_Cr, ofbkimageBAND_Cb, ofbkimageBAND_Y_LH,
                                     ofbkimageBAND_Y_HL, ofbkimageBAND_Y_HH}) {
      EXPECT_EQ(layers.Band(layer, band).Pixel(3, 3), 128) << layer << " " << band;
    }
  }
}

// R = Y + Cr, G = Y - 0.51 Cr - 0.19 Cb, B = Y + Cb: what programs do with the bands.
TEST(ImageLayersTest, TheProgramsFormulaGivesTheColourBack) {
  const int colours[][3] = {{200, 120, 90}, {90, 120, 150}, {120, 160, 100}, {255, 200, 180}};
  for (const auto& [r, g, b] : colours) {
    Layers layers(Plain(static_cast<uint8_t>(r), static_cast<uint8_t>(g), static_cast<uint8_t>(b)));
    for (OFbkImageLayer layer = 0; layer < 3; ++layer) {
      const double y = layers.Band(layer, ofbkimageBAND_Y).Pixel(2, 2);
      const double cr = layers.Band(layer, ofbkimageBAND_Cr).Pixel(2, 2) - 128.0;
      const double cb = layers.Band(layer, ofbkimageBAND_Cb).Pixel(2, 2) - 128.0;
      EXPECT_NEAR(y + cr, r, 2);
      EXPECT_NEAR(y - 0.51 * cr - 0.19 * cb, g, 2);
      EXPECT_NEAR(y + cb, b, 2);
    }
  }
}

// field-notes.md 9.4: with Cr and Cb swapped, as in Sony's first samples, red becomes blue.
TEST(ImageLayersTest, SwappedColourDifferencesSwapRedAndBlue) {
  const int r = 200, g = 120, b = 90;
  Layers layers(Plain(r, g, b));
  const double y = layers.Band(ofbkimageLAYER_H, ofbkimageBAND_Y).Pixel(2, 2);
  const double cr = layers.Band(ofbkimageLAYER_H, ofbkimageBAND_Cb).Pixel(2, 2) - 128.0;
  const double cb = layers.Band(ofbkimageLAYER_H, ofbkimageBAND_Cr).Pixel(2, 2) - 128.0;
  EXPECT_NEAR(y + cr, b, 2);
  EXPECT_NEAR(y + cb, r, 2);
}

// The four Y bands of a layer give a luminance image of twice its resolution.
TEST(ImageLayersTest, TheHighBandsDoubleTheResolution) {
  Picture picture = Plain(0, 0, 0);
  for (int y = 0; y < kHeight; ++y) {
    for (int x = 0; x < kWidth; ++x)
      std::memset(picture.At(x, y), 100 + 4 * (x % 5) + 8 * (y % 3), 3);
  }
  Layers layers(picture);
  const auto band = [&](OFbkImageBand which, int x, int y) {
    return int{layers.Band(ofbkimageLAYER_H, which).Pixel(x, y)};
  };
  for (int y = 0; y < kHeight / 2 - 1; ++y) {  // not the row with the tag
    for (int x = 0; x < kWidth / 2; ++x) {
      const int ll = band(ofbkimageBAND_Y, x, y), lh = band(ofbkimageBAND_Y_LH, x, y) - 128;
      const int hl = band(ofbkimageBAND_Y_HL, x, y) - 128,
                hh = band(ofbkimageBAND_Y_HH, x, y) - 128;
      EXPECT_NEAR(ll + lh + hl + hh, *picture.At(2 * x, 2 * y), 3);
      EXPECT_NEAR(ll + lh - hl - hh, *picture.At(2 * x + 1, 2 * y), 3);
      EXPECT_NEAR(ll - lh + hl - hh, *picture.At(2 * x, 2 * y + 1), 3);
      EXPECT_NEAR(ll - lh - hl + hh, *picture.At(2 * x + 1, 2 * y + 1), 3);
    }
  }
}

TEST(ImageLayersTest, TheOriginIsTheTopLeftCorner) {
  Picture picture = Plain(0, 0, 0);
  for (int y = 0; y < 16; ++y) {
    for (int x = 0; x < 16; ++x) std::memset(picture.At(x, y), 240, 3);
  }
  Layers layers(picture);
  for (OFbkImageLayer layer = 0; layer < 3; ++layer) {
    OFbkImage y = layers.Band(layer, ofbkimageBAND_Y);
    EXPECT_EQ(y.Pixel(0, 0), 240);
    EXPECT_EQ(y.Pixel(y.Width() - 1, 0), 0);
    EXPECT_EQ(y.Pixel(y.Width() - 1, y.Height() - 1), 0);
  }
}

// Frequencies are pixels of layer M over 16; the right half of 16 x 12 is 96 pixels.
TEST(ImageLayersTest, ColoursAreDetectedAndCounted) {
  Picture picture = Plain(0, 0, 0);
  for (int y = 0; y < kHeight; ++y) {
    for (int x = kWidth / 2; x < kWidth; ++x) {
      uint8_t* const rgb = picture.At(x, y);
      rgb[0] = 200, rgb[1] = 100, rgb[2] = 150;
    }
  }
  OCdtInfo pink;
  pink.Init(0, ocdtCHANNEL5);
  for (int segment = 0; segment < 32; ++segment) pink.Set(segment, 255, 160, 200, 120);
  OCdtInfo black;
  black.Init(0, ocdtCHANNEL0);
  black.Set(0, 130, 126, 130, 126);
  ColourTables tables;
  tables.Set(pink);
  tables.Set(black);
  Layers layers(picture, tables, 0x1234);
  OFbkImage detected = layers.Band(ofbkimageLAYER_C, ofbkimageBAND_CDT);
  EXPECT_EQ(detected.Pixel(0, 0), 0x01);
  EXPECT_EQ(detected.Pixel(15, 10), 0x20);
  // Programs read the tag through an OFbkImage of any band, or from the bytes of the last row.
  const byte tag[16] = {0x34, 0x12, 0, 0, 0, 6, 0, 0, 6, 0, 0, 0, 0, 0, 0, 0};
  const OFbkImageBand colour[] = {ofbkimageBAND_Y,    ofbkimageBAND_Cr,   ofbkimageBAND_Cb,
                                  ofbkimageBAND_Y_LH, ofbkimageBAND_Y_HL, ofbkimageBAND_Y_HH};
  for (const OFbkImageLayer layer : {ofbkimageLAYER_H, ofbkimageLAYER_M, ofbkimageLAYER_C}) {
    SCOPED_TRACE(layer);  // L is too narrow for a tag here
    const bool is_c = layer == ofbkimageLAYER_C;
    for (const OFbkImageBand band : colour) {
      OFbkImage image = layers.Band(layer, is_c ? ofbkimageBAND_CDT : band);
      EXPECT_EQ(image.FieldCounter(), 0x1234);
      EXPECT_EQ(image.ColorFrequency(ocdtCHANNEL5), 6);
      EXPECT_EQ(image.ColorFrequency(ocdtCHANNEL0), 6);
      EXPECT_EQ(image.ColorFrequency(ocdtCHANNEL1), 0);
    }
    OFbkImage first = layers.Band(layer, is_c ? ofbkimageBAND_CDT : ofbkimageBAND_Y);
    const byte* const last_row =
        first.Pointer() + (first.Width() + first.Skip()) * (first.Height() - 1);
    EXPECT_EQ(std::memcmp(last_row, tag, sizeof tag), 0);
  }
}

TEST(ImageLayersTest, WithoutAColourTableLayerCIsEmptyButForTheTag) {
  Layers layers(Plain(200, 100, 150), {}, 7);
  OFbkImage detected = layers.Band(ofbkimageLAYER_C, ofbkimageBAND_CDT);
  EXPECT_EQ(detected.FieldCounter(), 7);
  const int above = detected.Width() * (detected.Height() - 1);
  EXPECT_EQ(std::count(detected.Pointer(), detected.Pointer() + above, 0), above);
}

TEST(ImageLayersTest, ExposureIsAppliedToEveryColour) {
  Exposure exposure = Plain();
  exposure[0][50] = 100;
  Layers layers(Plain(50, 100, 100), {}, 1, exposure);
  EXPECT_EQ(layers.Band(ofbkimageLAYER_M, ofbkimageBAND_Y).Pixel(1, 1), 100);
}

}  // namespace
}  // namespace openr_host
