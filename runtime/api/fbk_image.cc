// OFbkImage: gives programs the pixels of one band of a camera image, and the information that the
// camera stores in the image.
#include <OPENR/OFbkImage.h>

#include <bit>

namespace {

// The position of a band in an image.  A band has one value for each pixel: the brightness Y, the
// colours Cr and Cb, the high-frequency parts LH, HL and HH of Y, or the result of colour
// detection, CDT.  An image stores its bands row by row: row 0 of each band, then row 1 of each
// band, and so on.
struct BandPlace {
  // Number of the band in the order of the image's bands, from 0; -1 if the image lacks the band.
  int index;
  int bands;  // number of bands of the image
};

BandPlace PlaceOf(ODataType type, OFbkImageBand band) {
  constexpr BandPlace kNone = {-1, 0};
  switch (type) {
    case odataFBK_CDT:
      return band == ofbkimageBAND_CDT ? BandPlace{0, 1} : kNone;
    case odataFBK_YCrCb:
      return band <= ofbkimageBAND_Cb ? BandPlace{static_cast<int>(band), 3} : kNone;
    case odataFBK_YCrCb_HPF:
      if (band <= ofbkimageBAND_Cb) return {static_cast<int>(band), 6};
      // In an image, the bands LH, HL and HH follow the band Cb.  In OFbkImageBand, the constant of
      // CDT comes between the constants of Cb and LH.  So the index of each of these three bands in
      // the image is its constant minus 1.
      if (band >= ofbkimageBAND_Y_LH && band <= ofbkimageBAND_Y_HH) {
        return {static_cast<int>(band) - 1, 6};
      }
      return kNone;
    default:
      return kNone;
  }
}

// The size of the tag in bytes.  The tag is information about the image, which the camera writes
// over the first 16 pixels of the last row (robot.md, 11.2).  Bytes 0 and 1 are the field counter,
// the camera's count of its pictures.  Each byte from 4 on tells how many pixels one channel of
// colour detection has detected, divided by 16: bytes 4 to 7 for channels 4 to 7, bytes 8 to 11 for
// channels 0 to 3.
constexpr int kTagSize = 16;
constexpr int kFrequencies4To7 = 4;
constexpr int kFrequencies0To3 = 8;

}  // namespace

OFbkImage::OFbkImage(OFbkImageInfo* info, byte* data, OFbkImageBand band)
    : pointer_(nullptr), width_(0), height_(0), skip_(0), tag_(nullptr) {
  if (info == nullptr || data == nullptr) return;
  const BandPlace place = PlaceOf(info->type, band);
  if (place.index < 0) return;
  width_ = static_cast<int>(info->width);
  height_ = static_cast<int>(info->height);
  skip_ = width_ * (place.bands - 1);
  pointer_ = data + place.index * width_;
  // The tag is in the last row of the image's first band (Y, or the only band), whichever band is
  // asked for.  The first band begins at `data`.
  if (width_ >= kTagSize && height_ > 0) tag_ = data + (width_ + skip_) * (height_ - 1);
}

byte OFbkImage::Pixel(int x, int y) const {
  return IsValid() ? pointer_[(width_ + skip_) * y + x] : byte{0};
}

// Returns the first four bytes of the tag, the camera's information about the image, as a number,
// low byte first.  The byte order is our choice.
longword OFbkImage::GetTagInfo() const {
  if (tag_ == nullptr) return 0;
  return longword{tag_[0]} | longword{tag_[1]} << 8 | longword{tag_[2]} << 16 |
         longword{tag_[3]} << 24;
}

word OFbkImage::FieldCounter() const { return static_cast<word>(GetTagInfo() & 0xffff); }

byte OFbkImage::ColorFrequency(OCdtChannel channel) const {
  if (tag_ == nullptr || !std::has_single_bit(channel) || channel > ocdtCHANNEL7) return 0;
  const int number = std::countr_zero(channel);
  return number < 4 ? tag_[kFrequencies0To3 + number] : tag_[kFrequencies4To7 + number - 4];
}
