// Data vectors: robot 3, 4, 5, 11, 12, 13.5.
#include <OPENR/ODataFormats.h>
#include <OPENR/OPrimitiveControl.h>
#include <OPENR/OVRData.h>

#include "abi.h"

namespace {

void CheckVectorInfo() {
  SIZE(ODataVectorInfo, 192);
  AT(ODataVectorInfo, memRegionID, 0);
  AT(ODataVectorInfo, physAddr, 4);
  AT(ODataVectorInfo, offset, 8);
  AT(ODataVectorInfo, totalSize, 12);
  AT(ODataVectorInfo, type, 16);
  AT(ODataVectorInfo, infoOffset, 20);
  AT(ODataVectorInfo, infoSize, 24);
  AT(ODataVectorInfo, maxNumData, 28);
  AT(ODataVectorInfo, numData, 32);
  AT(ODataVectorInfo, syncKey, 36);
  AT(ODataVectorInfo, wait, 40);
  AT(ODataVectorInfo, optOffset, 44);
  AT(ODataVectorInfo, optSize, 48);
  AT(ODataVectorInfo, padding, 52);
  AT(ODataVectorInfo, optional, 64);
}

// OCommandInfo and OSensorFrameInfo have the same eight fields (robot 5.1).
#define CHECK_INFO(type_name)    \
  SIZE(type_name, 32);           \
  AT(type_name, type, 0);        \
  AT(type_name, primitiveID, 4); \
  AT(type_name, frameNumber, 8); \
  AT(type_name, numFrames, 12);  \
  AT(type_name, frameSize, 16);  \
  AT(type_name, dataOffset, 20); \
  AT(type_name, dataSize, 24);   \
  AT(type_name, padding, 28)

void CheckImages() {
  SIZE(OFbkImageInfo, 32);
  AT(OFbkImageInfo, type, 0);
  AT(OFbkImageInfo, primitiveID, 4);
  AT(OFbkImageInfo, frameNumber, 8);
  AT(OFbkImageInfo, dataOffset, 12);
  AT(OFbkImageInfo, dataSize, 16);
  AT(OFbkImageInfo, width, 20);
  AT(OFbkImageInfo, height, 24);
  AT(OFbkImageInfo, padding, 28);
  AT(OFbkImageVectorData, info, 192);

  SIZE(OCdtInfo, 144);
  AT(OCdtInfo, type, 0);
  AT(OCdtInfo, primitiveID, 4);
  AT(OCdtInfo, channel, 8);
  AT(OCdtInfo, table, 12);
  SIZE(OCdtVectorData, 192 + 8 * 144);
}

void CheckSound() {
  SIZE(OSoundInfo, 64);
  AT(OSoundInfo, type, 0);
  AT(OSoundInfo, primitiveID, 4);
  AT(OSoundInfo, frameNumber, 8);
  AT(OSoundInfo, frameSize, 12);
  AT(OSoundInfo, dataOffset, 16);
  AT(OSoundInfo, maxDataSize, 20);
  AT(OSoundInfo, dataSize, 24);
  AT(OSoundInfo, format, 28);
  AT(OSoundInfo, channel, 30);
  AT(OSoundInfo, samplingRate, 32);
  AT(OSoundInfo, bitsPerSample, 34);
  AT(OSoundInfo, actualDataSize, 36);
  AT(OSoundInfo, padding, 40);
  AT(OSoundVectorData, info, 192);
  SIZE(OSoundSampleStereo16, 4);
}

void CheckPrimitiveMap() {
  SIZE(OPrimitiveInfo, 160);
  AT(OPrimitiveInfo, type, 0);
  AT(OPrimitiveInfo, primitiveID, 4);
  AT(OPrimitiveInfo, primitiveType, 8);
  AT(OPrimitiveInfo, sensorType, 12);
  AT(OPrimitiveInfo, primitiveStatus, 16);
  AT(OPrimitiveInfo, padding, 20);
  AT(OPrimitiveInfo, locator, 32);
  SIZE(OCPCInfo, 12);
  AT(OCPCInfo, type, 0);
  AT(OCPCInfo, cpcClass, 4);
  AT(OCPCInfo, cpcSubClass, 6);
  AT(OCPCInfo, cpcType, 8);
  AT(OCPCInfo, numReceptors, 10);
  SIZE(OVRData, 16);
  AT(OVRData, status, 0);
  AT(OVRData, type, 4);
  AT(OVRData, dataVectorID, 8);
  AT(OVRData, offset, 12);
}

void CheckCommandValues() {
  SIZE(OJointCommandValue2, 8);
  AT(OJointCommandValue2, padding, 4);
  SIZE(OJointCommandValue3, 8);
  AT(OJointCommandValue3, reserved, 4);
  AT(OJointCommandValue3, padding, 6);
  SIZE(OJointCommandValue4, 8);
  AT(OJointCommandValue4, period, 4);
  AT(OJointCommandValue4, reserved, 6);
  SIZE(OLEDCommandValue2, 8);
  AT(OLEDCommandValue2, period, 4);
  AT(OLEDCommandValue2, reserved, 6);
  SIZE(OLEDCommandValue3, 8);
  AT(OLEDCommandValue3, mode, 2);
  AT(OLEDCommandValue3, period, 4);
  AT(OLEDCommandValue3, reserved, 6);
  SIZE(OJointCommandValue, 8);
  AT(OJointCommandValue, p, 4);
  AT(OJointCommandValue, i, 5);
  AT(OJointCommandValue, d, 6);
  AT(OJointCommandValue, padding, 7);
  SIZE(OLEDCommandValue, 8);
  AT(OLEDCommandValue, period, 4);
  AT(OLEDCommandValue, padding, 6);
  SIZE(OCameraCommandValue, 8);
  AT(OCameraCommandValue, param, 2);
  SIZE(ORawJointCommandValue, 8);
  SIZE(ORawJointCommandValue2, 8);
  SIZE(ORawCameraCommandValue, 8);
  SIZE(ORawLEDCommandValue, 8);
}

#define CHECK_SENSOR(type_name) \
  SIZE(type_name, 16);          \
  AT(type_name, value, 0);      \
  AT(type_name, signal, 4);     \
  AT(type_name, padding, 6)

void CheckSensorValues() {
  CHECK_SENSOR(OSensorValue);
  CHECK_SENSOR(OAcceleration);
  CHECK_SENSOR(OAngularVelocity);
  CHECK_SENSOR(OTemperature);
  CHECK_SENSOR(OForce);
  CHECK_SENSOR(OPressure);
  CHECK_SENSOR(OLength);
  CHECK_SENSOR(OSwitchStatus);
  SIZE(OJointValue, 16);
  AT(OJointValue, value, 0);
  AT(OJointValue, signal, 4);
  AT(OJointValue, pwmDuty, 6);
  AT(OJointValue, refValue, 8);
  AT(OJointValue, refSignal, 12);
  AT(OJointValue, padding, 14);
}

}  // namespace

void CheckVectors() {
  CheckVectorInfo();
  CHECK_INFO(OCommandInfo);
  SIZE(OCommandValue, 8);
  SIZE(OCommandData, 128);
  SIZE(OCommandVectorData, 192 + 32);
  AT(OCommandVectorData, info, 192);
  CHECK_INFO(OSensorFrameInfo);
  SIZE(OSensorFrameData, 256);
  SIZE(OSensorFrameVectorData, 192 + 32);
  AT(OSensorFrameVectorData, info, 192);
  CheckImages();
  CheckSound();
  CheckPrimitiveMap();
}

void CheckValues() {
  CheckCommandValues();
  CheckSensorValues();
  SIZE(OPrimitiveControl_SpeakerVolume, 4);  // robot 13.3
  SIZE(OPrimitiveControl_SpeakerSoundType, 4);
  SIZE(OPrimitiveControl_MasterTuningMIDI, 2);
  SIZE(OPrimitiveControl_CameraParam, 4);
  SIZE(OPrimitiveControl_Cdt, 104);
}
