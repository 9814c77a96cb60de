// The image vectors of the camera, and the tables for colour detection.  An image vector has one
// picture in four layers.  Three layers have the picture in three sizes; the fourth layer says
// which colours were detected in each pixel.
#ifndef OPENR_FORMATS_IMAGES_H_INCLUDED
#define OPENR_FORMATS_IMAGES_H_INCLUDED

#include <OPENR/formats/vector_info.h>

// The number of a layer, which is the index of its image in the vector.  The image sizes below are
// those of the ERS-210 (Model Information, 4.1.2).
typedef longword OFbkImageLayer;
const OFbkImageLayer ofbkimageLAYER_H = 0;  // 176 x 144 pixels, YCrCb
const OFbkImageLayer ofbkimageLAYER_M = 1;  // 88 x 72 pixels, YCrCb
const OFbkImageLayer ofbkimageLAYER_L = 2;  // 44 x 36 pixels, YCrCb
const OFbkImageLayer ofbkimageLAYER_C = 3;  // 88 x 72 pixels, colour detection
const size_t ofbkimageNUM_LAYERS = 4;       // number of layers; the name is our choice

// Describes one camera image of a vector; 32 bytes.
struct OFbkImageInfo {
  ODataType type;  // the type odataFBK_YCrCb, odataFBK_YCrCb_HPF or odataFBK_CDT
  OPrimitiveID primitiveID;
  longword frameNumber;
  longword dataOffset;  // offset in bytes from the start of the vector
  longword dataSize;    // in bytes
  longword width;       // in pixels
  longword height;
  longword padding[1];
};

struct OFbkImageVectorData {
  ODataVectorInfo vectorInfo;
  OFbkImageInfo info[1];  // in memory the array has vectorInfo.maxNumData elements, one per layer

  void SetPrimitiveID(OPrimitiveID id) {
    for (size_t i = 0; i < ofbkimageNUM_LAYERS; i++) GetInfo(static_cast<int>(i))->primitiveID = id;
  }
  OFbkImageInfo* GetInfo(int index) { return info + index; }
  byte* GetData(int index) { return reinterpret_cast<byte*>(this) + GetInfo(index)->dataOffset; }
};

// ---- colour detection tables

// A channel of colour detection as a bit mask.  A pixel of image layer C has the bits of all
// channels that detect its colour.
typedef longword OCdtChannel;
const OCdtChannel ocdtCHANNEL_UNDEF = 0;
const OCdtChannel ocdtCHANNEL0 = 0x01;
const OCdtChannel ocdtCHANNEL1 = 0x02;
const OCdtChannel ocdtCHANNEL2 = 0x04;
const OCdtChannel ocdtCHANNEL3 = 0x08;
const OCdtChannel ocdtCHANNEL4 = 0x10;
const OCdtChannel ocdtCHANNEL5 = 0x20;
const OCdtChannel ocdtCHANNEL6 = 0x40;
const OCdtChannel ocdtCHANNEL7 = 0x80;
const size_t ocdtNUM_CHANNELS = 8;

const size_t ocdtMAX_Y_SEGMENT = 32;   // the luminance range has 32 segments
const longword ocdtINIT = 0x80808080;  // value of a segment in which no colour is detected
const longword ocdtCb_MAX_MASK = 0xff000000;
const longword ocdtCb_MIN_MASK = 0x00ff0000;
const longword ocdtCr_MAX_MASK = 0x0000ff00;
const longword ocdtCr_MIN_MASK = 0x000000ff;

// The table of one channel of colour detection, 144 bytes: for each luminance segment the range of
// Cr and Cb to detect.
struct OCdtInfo {
  ODataType type;  // the type odataCDT
  OPrimitiveID primitiveID;
  OCdtChannel channel;
  longword table[ocdtMAX_Y_SEGMENT];  // from the highest byte: Cb max, Cb min, Cr max, Cr min
  longword padding[1];

  // Empties the colour detection table of channel `chan` of the camera `id`.
  void Init(OPrimitiveID id, OCdtChannel chan);

  // Sets the colours that the camera shall detect in luminance segment `y_segment`: ranges of Cr
  // and Cb.  A `y_segment` outside of 0..31 changes nothing.
  void Set(int y_segment, byte cr_max, byte cr_min, byte cb_max, byte cb_min);
};

struct OCdtVectorData {
  ODataVectorInfo vectorInfo;
  OCdtInfo info[ocdtNUM_CHANNELS];

  void SetNumData(size_t n) { vectorInfo.numData = static_cast<longword>(n); }
  OCdtInfo* GetInfo(int index) { return info + index; }
};

#endif  // OPENR_FORMATS_IMAGES_H_INCLUDED
