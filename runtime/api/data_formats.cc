// The functions of OCdtInfo, a table with the settings of the camera's colour detection.  The table
// divides brightness into 32 segments and has, for each segment, the colours that the camera shall
// detect.
#include <OPENR/ODataFormats.h>

void OCdtInfo::Init(OPrimitiveID id, OCdtChannel chan) {
  type = odataCDT;
  primitiveID = id;
  channel = chan;
  for (longword& segment : table) segment = ocdtINIT;
  padding[0] = 0;
}

// Sets which colours the camera shall detect in pixels whose brightness is in segment `y_segment`.
// The colours are given by the largest and smallest values of Cr and Cb.
void OCdtInfo::Set(int y_segment, byte cr_max, byte cr_min, byte cb_max, byte cb_min) {
  if (y_segment < 0 || y_segment >= static_cast<int>(ocdtMAX_Y_SEGMENT)) return;
  table[y_segment] =
      longword{cb_max} << 24 | longword{cb_min} << 16 | longword{cr_max} << 8 | longword{cr_min};
}
