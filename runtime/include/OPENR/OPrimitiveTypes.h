// Kinds of primitives and of sensors.
//
// The word after the dash of a locator ("PRM:/r1/c1-Joint2:j1") is the name of the kind of the
// primitive.  Each such name has a constant oprimitive..._NAME.  The words Joint2, Joint3, Joint4,
// Sensor, LED2, LED3, Speaker, Mic and FbkImageSensor are from locators in the Model Information
// guides.  The other words, the names oprimitiveUNDEF and osensorUNDEF, and the prefix osensor are
// inferred.
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

#define oprimitiveCOORDINATE_NAME "Coordinate"
#define oprimitiveRECEPTOR_NAME "Receptor"
#define oprimitivePLUG_NAME "Plug"
#define oprimitiveLINK_NAME "Link"
#define oprimitiveJOINT_NAME "Joint"
#define oprimitiveSENSOR_NAME "Sensor"
#define oprimitiveSPEAKER_NAME "Speaker"
#define oprimitiveMIC_NAME "Mic"
#define oprimitiveFBKIMAGESENSOR_NAME "FbkImageSensor"
#define oprimitiveLED_NAME "LED"
#define oprimitiveJOINT2_NAME "Joint2"
#define oprimitiveLED2_NAME "LED2"
#define oprimitiveJOINT3_NAME "Joint3"
#define oprimitiveJOINT4_NAME "Joint4"
#define oprimitiveBLUETOOTH_NAME "Bluetooth"
#define oprimitiveLED3_NAME "LED3"

typedef longword OSensorType;
const OSensorType osensorUNDEF = 0;
const OSensorType osensorSWITCH = 1;
const OSensorType osensorACCELEROMETER = 2;
const OSensorType osensorGYROMETER = 3;
const OSensorType osensorTACTILE_SENSOR = 4;
const OSensorType osensorTHERMOMETER = 5;
const OSensorType osensorPSD = 6;  // distance sensor
const OSensorType osensorROTARY_SENSOR = 7;
const OSensorType osensorBT_SWITCH = 8;
const OSensorType osensorRAW_SENSOR = 9;
const OSensorType osensorTM_SENSOR = 10;

#endif  // OPENR_OPRIMITIVETYPES_H_INCLUDED
