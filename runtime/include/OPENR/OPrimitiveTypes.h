// Kinds of primitives and of sensors.
//
// The word behind the dash of a locator ("PRM:/r1/c1-Joint2:j1") is the matching _NAME.
// Joint2, Joint3, Joint4, Sensor, LED2, LED3, Speaker, Mic and FbkImageSensor stand in
// locators of the Model Information guides; the other words, the two names for 0 and the
// prefix osensor are inferred.
#ifndef OPENR_OPRIMITIVETYPES_H_INCLUDED
#define OPENR_OPRIMITIVETYPES_H_INCLUDED

#include <Types.h>

typedef longword OPrimitiveType;
const OPrimitiveType oprimitiveUNDEF = 0;
const OPrimitiveType oprimitiveCOORDINATE = 1;
const OPrimitiveType oprimitiveRECEPTOR = 2;
const OPrimitiveType oprimitivePLUG = 3;
const OPrimitiveType oprimitiveLINK = 4;
const OPrimitiveType oprimitiveJOINT = 5;
const OPrimitiveType oprimitiveSENSOR = 6;
const OPrimitiveType oprimitiveSPEAKER = 7;
const OPrimitiveType oprimitiveMIC = 8;
const OPrimitiveType oprimitiveFBKIMAGESENSOR = 9;
const OPrimitiveType oprimitiveLED = 10;
const OPrimitiveType oprimitiveJOINT2 = 11;  // ERS-210: every joint with feedback
const OPrimitiveType oprimitiveLED2 = 12;    // ERS-210: every LED
const OPrimitiveType oprimitiveJOINT3 = 13;  // ERS-210: the ears
const OPrimitiveType oprimitiveJOINT4 = 14;
const OPrimitiveType oprimitiveBLUETOOTH = 15;
const OPrimitiveType oprimitiveLED3 = 16;

const char* const oprimitiveCOORDINATE_NAME = "Coordinate";
const char* const oprimitiveRECEPTOR_NAME = "Receptor";
const char* const oprimitivePLUG_NAME = "Plug";
const char* const oprimitiveLINK_NAME = "Link";
const char* const oprimitiveJOINT_NAME = "Joint";
const char* const oprimitiveSENSOR_NAME = "Sensor";
const char* const oprimitiveSPEAKER_NAME = "Speaker";
const char* const oprimitiveMIC_NAME = "Mic";
const char* const oprimitiveFBKIMAGESENSOR_NAME = "FbkImageSensor";
const char* const oprimitiveLED_NAME = "LED";
const char* const oprimitiveJOINT2_NAME = "Joint2";
const char* const oprimitiveLED2_NAME = "LED2";
const char* const oprimitiveJOINT3_NAME = "Joint3";
const char* const oprimitiveJOINT4_NAME = "Joint4";
const char* const oprimitiveBLUETOOTH_NAME = "Bluetooth";
const char* const oprimitiveLED3_NAME = "LED3";

typedef longword OSensorType;
const OSensorType osensorUNDEF = 0;
const OSensorType osensorSWITCH = 1;
const OSensorType osensorACCELEROMETER = 2;
const OSensorType osensorGYROMETER = 3;
const OSensorType osensorTACTILE_SENSOR = 4;
const OSensorType osensorTHERMOMETER = 5;
const OSensorType osensorPSD = 6;  // distance
const OSensorType osensorROTARY_SENSOR = 7;
const OSensorType osensorBT_SWITCH = 8;
const OSensorType osensorRAW_SENSOR = 9;
const OSensorType osensorTM_SENSOR = 10;

#endif  // OPENR_OPRIMITIVETYPES_H_INCLUDED
