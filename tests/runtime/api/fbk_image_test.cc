#include <OPENR/OFbkImage.h>
#include <gtest/gtest.h>

#include <vector>

namespace {

constexpr int kWidth = 20;
constexpr int kHeight = 3;

// An image whose byte at offset i is i % 251, so that the value of a pixel shows its offset.
struct Image {
  OFbkImageInfo info = {};
  std::vector<byte> data;

  Image(ODataType type, int bands) : data(kWidth * kHeight * bands) {
    info.type = type;
    info.width = kWidth;
    info.height = kHeight;
    for (size_t i = 0; i < data.size(); ++i) data[i] = static_cast<byte>(i % 251);
  }
  OFbkImage Band(OFbkImageBand band) { return OFbkImage(&info, data.data(), band); }
};

TEST(OFbkImageTest, BandsAreInterleavedRowByRow) {
  Image image(odataFBK_YCrCb, 3);
  const OFbkImage cb = image.Band(ofbkimageBAND_Cb);
  ASSERT_TRUE(cb.IsValid());
  EXPECT_EQ(cb.Width(), kWidth);
  EXPECT_EQ(cb.Height(), kHeight);
  EXPECT_EQ(cb.Skip(), 2 * kWidth);
  EXPECT_EQ(cb.Pointer(), image.data.data() + 2 * kWidth);
  EXPECT_EQ(cb.Pixel(7, 1), 2 * kWidth + 3 * kWidth + 7);
}

TEST(OFbkImageTest, TheSixBandTypeSkipsFiveRowsAndHasTheHighBandsLast) {
  Image image(odataFBK_YCrCb_HPF, 6);
  EXPECT_EQ(image.Band(ofbkimageBAND_Y).Skip(), 5 * kWidth);
  EXPECT_EQ(image.Band(ofbkimageBAND_Cb).Pointer(), image.data.data() + 2 * kWidth);
  EXPECT_EQ(image.Band(ofbkimageBAND_Y_LH).Pointer(), image.data.data() + 3 * kWidth);
  EXPECT_EQ(image.Band(ofbkimageBAND_Y_HH).Pointer(), image.data.data() + 5 * kWidth);
}

TEST(OFbkImageTest, TheColourDetectionImageHasNoSkip) {
  Image image(odataFBK_CDT, 1);
  const OFbkImage cdt = image.Band(ofbkimageBAND_CDT);
  ASSERT_TRUE(cdt.IsValid());
  EXPECT_EQ(cdt.Skip(), 0);
  EXPECT_EQ(cdt.Pixel(1, 1), kWidth + 1);
}

TEST(OFbkImageTest, ABandThatTheImageLacksIsInvalidAndAnswersZero) {
  Image image(odataFBK_YCrCb, 3);
  const OFbkImage none = image.Band(ofbkimageBAND_CDT);
  EXPECT_FALSE(none.IsValid());
  EXPECT_EQ(none.Pointer(), nullptr);
  EXPECT_EQ(none.Width() + none.Height() + none.Skip(), 0);
  EXPECT_EQ(none.Pixel(0, 0), 0);
  EXPECT_EQ(none.FieldCounter(), 0);
  EXPECT_EQ(none.GetTagInfo(), 0u);
}

TEST(OFbkImageTest, TheTagBeginsWithALongwordThatHoldsTheFieldCounter) {
  Image image(odataFBK_YCrCb, 3);
  byte* const tag = image.data.data() + 2 * 3 * kWidth;
  tag[0] = 0x78;
  tag[1] = 0x56;
  tag[2] = 0x34;
  tag[3] = 0x92;
  const OFbkImage y = image.Band(ofbkimageBAND_Y);
  EXPECT_EQ(y.GetTagInfo(), 0x92345678u);
  EXPECT_EQ(y.FieldCounter(), 0x5678);
}

TEST(OFbkImageTest, HighBandsExistInTheSixBandTypeOnly) {
  EXPECT_FALSE(Image(odataFBK_YCrCb, 3).Band(ofbkimageBAND_Y_LH).IsValid());
  EXPECT_FALSE(Image(odataFBK_CDT, 1).Band(ofbkimageBAND_Y).IsValid());
  EXPECT_FALSE(Image(odataFBK_YCrCb_HPF, 6).Band(7).IsValid());
  EXPECT_FALSE(Image(odataIMAGE, 3).Band(ofbkimageBAND_Y).IsValid());
}

TEST(OFbkImageTest, NoDataMeansInvalid) {
  Image image(odataFBK_YCrCb, 3);
  EXPECT_FALSE(OFbkImage(&image.info, nullptr, ofbkimageBAND_Y).IsValid());
  EXPECT_FALSE(OFbkImage(nullptr, image.data.data(), ofbkimageBAND_Y).IsValid());
}

// In the last row of Y, bytes 0 and 1 are the counter, 4..7 channels 4..7, 8..11 channels 0..3.
TEST(OFbkImageTest, TheTagIsReadFromTheLastRowOfTheYBand) {
  Image image(odataFBK_YCrCb, 3);
  byte* const tag = image.data.data() + 3 * kWidth * (kHeight - 1);
  for (int i = 0; i < 16; ++i) tag[i] = static_cast<byte>(100 + i);
  tag[0] = 0x34;
  tag[1] = 0x12;
  const OFbkImage y = image.Band(ofbkimageBAND_Y);
  EXPECT_EQ(y.FieldCounter(), 0x1234);
  EXPECT_EQ(y.ColorFrequency(ocdtCHANNEL0), 108);
  EXPECT_EQ(y.ColorFrequency(ocdtCHANNEL3), 111);
  EXPECT_EQ(y.ColorFrequency(ocdtCHANNEL4), 104);
  EXPECT_EQ(y.ColorFrequency(ocdtCHANNEL7), 107);
}

TEST(OFbkImageTest, ColorFrequencyIsZeroForWhatIsNotOneChannel) {
  Image image(odataFBK_YCrCb, 3);
  const OFbkImage y = image.Band(ofbkimageBAND_Y);
  EXPECT_EQ(y.ColorFrequency(0), 0);
  EXPECT_EQ(y.ColorFrequency(ocdtCHANNEL0 | ocdtCHANNEL1), 0);
  EXPECT_EQ(y.ColorFrequency(0x100), 0);
}

TEST(OFbkImageTest, EveryBandAnswersFromTheTagOfItsLayer) {
  Image image(odataFBK_YCrCb_HPF, 6);
  byte* const tag = image.data.data() + 6 * kWidth * (kHeight - 1);
  tag[0] = 0x34;
  tag[1] = 0x12;
  tag[8] = 77;
  for (const OFbkImageBand band : {ofbkimageBAND_Y, ofbkimageBAND_Cr, ofbkimageBAND_Cb,
                                   ofbkimageBAND_Y_LH, ofbkimageBAND_Y_HL, ofbkimageBAND_Y_HH}) {
    EXPECT_EQ(image.Band(band).FieldCounter(), 0x1234) << band;
    EXPECT_EQ(image.Band(band).ColorFrequency(ocdtCHANNEL0), 77) << band;
  }
}

TEST(OFbkImageTest, TheTagOfColourDetectionIsInItsLastRow) {
  Image image(odataFBK_CDT, 1);
  byte* const tag = image.data.data() + kWidth * (kHeight - 1);
  tag[0] = 0x34;
  tag[1] = 0x12;
  tag[11] = 5;
  const OFbkImage cdt = image.Band(ofbkimageBAND_CDT);
  EXPECT_EQ(cdt.FieldCounter(), 0x1234);
  EXPECT_EQ(cdt.ColorFrequency(ocdtCHANNEL3), 5);
}

TEST(OFbkImageTest, ALayerTooNarrowForATagAnswersZero) {
  Image image(odataFBK_CDT, 1);
  image.info.width = 15;
  EXPECT_EQ(image.Band(ofbkimageBAND_CDT).FieldCounter(), 0);
}

}  // namespace
