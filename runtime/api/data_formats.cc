// The functions of OCdtInfo, a table of colour detection.  For each of 32 segments of brightness,
// the table has the colours that the camera shall detect.
#include <OPENR/ODataFormats.h>

void OCdtInfo::Init(OPrimitiveID id, OCdtChannel chan) {
  type = odataCDT;
  primitiveID = id;
  channel = chan;
  for (longword& segment : table) segment = ocdtINIT;
  padding[0] = 0;
}

// Sets the colours that the camera shall detect in segment `y_segment`, a range of brightness: the
// limits of Cr and Cb.
void OCdtInfo::Set(int y_segment, byte cr_max, byte cr_min, byte cb_max, byte cb_min) {
  if (y_segment < 0 || y_segment >= static_cast<int>(ocdtMAX_Y_SEGMENT)) return;
  table[y_segment] =
      longword{cb_max} << 24 | longword{cb_min} << 16 | longword{cr_max} << 8 | longword{cr_min};
}
