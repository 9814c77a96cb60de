// OFbkImage, which gives access to one band (brightness or a colour) of a camera image.
#ifndef OPENR_OFBKIMAGE_H_INCLUDED
#define OPENR_OFBKIMAGE_H_INCLUDED

#include <OPENR/ODataFormats.h>

// The bands of a camera image: luminance, the two colour differences (128 is neutral), the result
// of colour detection, and three bands that double the resolution of the luminance.
typedef longword OFbkImageBand;
const OFbkImageBand ofbkimageBAND_Y = 0;
const OFbkImageBand ofbkimageBAND_Y_LL = ofbkimageBAND_Y;
const OFbkImageBand ofbkimageBAND_Cr = 1;
const OFbkImageBand ofbkimageBAND_Cb = 2;
const OFbkImageBand ofbkimageBAND_CDT = 3;
const OFbkImageBand ofbkimageBAND_Y_LH = 4;
const OFbkImageBand ofbkimageBAND_Y_HL = 5;
const OFbkImageBand ofbkimageBAND_Y_HH = 6;

// Gives access to one band of a camera image.  An OFbkImage copies nothing and is valid as long as
// the image data.
//
// The bands of one image are interleaved row by row, in the order Y, Cr, Cb and, for
// odataFBK_YCrCb_HPF, LH, HL, HH.  The order of LH, HL and HH is inferred.  Programs do not depend
// on this order, because they find the rows of a band with Pointer() and Skip().  The colour
// detection image has only one band, so its Skip() is 0.
//
// The last row of the Y band, and of the colour detection image, begins with a tag of 16 bytes in
// place of pixels.  Bytes 0 and 1 are the field counter (the camera's count of its pictures), low
// byte first.  Bytes 4..7 are the colour frequencies of channels 4..7, bytes 8..11 those of
// channels 0..3.
class OFbkImage {
 public:
  OFbkImage(OFbkImageInfo* info, byte* data, OFbkImageBand band);

  // Returns whether the camera image has this band.  If it does not, all other functions return 0.
  bool IsValid() const { return pointer_ != 0; }

  byte* Pointer() const { return pointer_; }  // first pixel of the top row
  int Width() const { return width_; }        // in pixels
  int Height() const { return height_; }
  int Skip() const { return skip_; }  // distance in bytes from the end of a row to the next row

  // Returns a pixel of this band of the image; (0, 0) is the top left corner.  REQUIRES: 0 <= x <
  // Width(), 0 <= y < Height().
  byte Pixel(int x, int y) const;

  // These functions read the tag, 16 bytes that the camera stores in the image.  The tag is the
  // same for all bands of an image.  GetTagInfo() returns the first four bytes, low byte first.
  // FieldCounter() returns the first two of these bytes, the camera's count of its pictures.
  // ColorFrequency() returns the number of pixels that one channel of colour detection has found,
  // divided by 16.
  longword GetTagInfo() const;
  word FieldCounter() const;
  byte ColorFrequency(OCdtChannel channel) const;

 private:
  byte* pointer_;
  int width_;
  int height_;
  int skip_;
  const byte* tag_;  // first byte of the tag; NULL if the image is too narrow for a tag
};

#endif  // OPENR_OFBKIMAGE_H_INCLUDED
