// One band of a camera image.
#ifndef OPENR_OFBKIMAGE_H_INCLUDED
#define OPENR_OFBKIMAGE_H_INCLUDED

#include <OPENR/ODataFormats.h>

// Luminance, the two colour differences (128 is neutral), the colour detection result,
// and the three bands that double the luminance resolution.
typedef longword OFbkImageBand;
const OFbkImageBand ofbkimageBAND_Y = 0;
const OFbkImageBand ofbkimageBAND_Y_LL = ofbkimageBAND_Y;
const OFbkImageBand ofbkimageBAND_Cr = 1;
const OFbkImageBand ofbkimageBAND_Cb = 2;
const OFbkImageBand ofbkimageBAND_CDT = 3;
const OFbkImageBand ofbkimageBAND_Y_LH = 4;
const OFbkImageBand ofbkimageBAND_Y_HL = 5;
const OFbkImageBand ofbkimageBAND_Y_HH = 6;

// A view: it copies nothing and is valid as long as the image data are.
//
// The bands of one image are interleaved row by row, in the order Y, Cr, Cb and, for
// odataFBK_YCrCb_HPF, LH, HL, HH (that order is inferred; programs go by Skip()).  The
// colour detection image has one band and no skip.
//
// The last row of the Y band, and of the colour detection image, begins with 16 bytes of tag
// in place of pixels: the field counter in bytes 0 and 1, low byte first, and the colour
// frequencies of channels 4..7 in bytes 4..7 and of channels 0..3 in bytes 8..11.
class OFbkImage {
 public:
  OFbkImage(OFbkImageInfo* info, byte* data, OFbkImageBand band);

  // False when the image has no such band.  Then the other answers are 0.
  bool IsValid() const { return pointer_ != 0; }

  byte* Pointer() const { return pointer_; }  // first pixel of the top row
  int Width() const { return width_; }        // pixels
  int Height() const { return height_; }
  int Skip() const { return skip_; }  // bytes from the end of a row to the next row

  // REQUIRES: 0 <= x < Width(), 0 <= y < Height(); the origin is the top left corner.
  byte Pixel(int x, int y) const;

  // From the tag of the layer, so the same in all its bands: its first four bytes, low byte first;
  // the camera's count of fields, which is the low half of these; and the number of detected pixels
  // of one channel divided by 16.
  longword GetTagInfo() const;
  word FieldCounter() const;
  byte ColorFrequency(OCdtChannel channel) const;

 private:
  byte* pointer_;
  int width_;
  int height_;
  int skip_;
  const byte* tag_;  // its first byte; NULL when the layer is too narrow for one
};

#endif  // OPENR_OFBKIMAGE_H_INCLUDED
