// The functions of OCdtInfo, the tables of colour detection.
#include <OPENR/ODataFormats.h>

void OCdtInfo::Init(OPrimitiveID id, OCdtChannel chan) {
  type = odataCDT;
  primitiveID = id;
  channel = chan;
  for (longword& segment : table) segment = ocdtINIT;
  padding[0] = 0;
}

void OCdtInfo::Set(int y_segment, byte cr_max, byte cr_min, byte cb_max, byte cb_min) {
  if (y_segment < 0 || y_segment >= static_cast<int>(ocdtMAX_Y_SEGMENT)) return;
  table[y_segment] =
      longword{cb_max} << 24 | longword{cb_min} << 16 | longword{cr_max} << 8 | longword{cr_min};
}
