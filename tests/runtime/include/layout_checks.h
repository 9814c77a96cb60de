// Sizes and offsets of the robot's data structures, checked by the compiler.
//
// The data structures have the same layout on every host.  Structures with pointers, object
// ids or a time_t have the robot's layout only where those have 32 bits; they are in
// message_layout_checks.h.  C++11; includes nothing but the SDK's headers.
#ifndef TESTS_RUNTIME_INCLUDE_LAYOUT_CHECKS_H
#define TESTS_RUNTIME_INCLUDE_LAYOUT_CHECKS_H

#include <ERA201D1.h>
#include <IPv4Types.h>
#include <OPENR/OCalendarTime.h>
#include <OPENR/ODataArchive.h>
#include <OPENR/OFbkImage.h>
#include <OPENR/OPENRAPI.h>
#include <OPENR/OPENRMessages.h>
#include <SystemTime.h>
#include <TimeEvent.h>
#include <stddef.h>

// Message structs have a base with data; every compiler we use lays them out as C does.
#pragma GCC diagnostic ignored "-Winvalid-offsetof"

#define CHECK_SIZE(type, size) static_assert(sizeof(type) == (size), "size of " #type)
#define CHECK_OFFSET(type, field, offset) \
  static_assert(offsetof(type, field) == (offset), "offset of " #type "::" #field)

template <class Left, class Right>
struct SameType {
  static const bool value = false;
};
template <class Type>
struct SameType<Type, Type> {
  static const bool value = true;
};

// ---- basic types

CHECK_SIZE(byte, 1);
CHECK_SIZE(sbyte, 1);
CHECK_SIZE(word, 2);
CHECK_SIZE(sword, 2);
CHECK_SIZE(longword, 4);
CHECK_SIZE(slongword, 4);
CHECK_SIZE(int8, 1);
CHECK_SIZE(uint8, 1);
CHECK_SIZE(int16, 2);
CHECK_SIZE(uint16, 2);
CHECK_SIZE(int32, 4);
CHECK_SIZE(uint32, 4);
CHECK_SIZE(Selector, 4);
CHECK_SIZE(sError, 4);
CHECK_SIZE(OStatus, 4);
CHECK_SIZE(OPrimitiveID, 4);
CHECK_SIZE(MemoryRegionID, 4);
CHECK_SIZE(OPower, 1);
CHECK_SIZE(OVolumeSwitch, 1);
CHECK_SIZE(boolean, 4);
CHECK_SIZE(Port, 2);
CHECK_SIZE(Protocol, 2);
CHECK_SIZE(antError, 4);
CHECK_SIZE(SystemTime, 8);
CHECK_SIZE(RelativeTime, 8);
CHECK_SIZE(EventID, 4);

// Format strings need int, and not a long of the same size.
static_assert(SameType<longword, unsigned int>::value, "longword is printed with %u");
static_assert(SameType<slongword, int>::value, "slongword is printed with %d");
static_assert(SameType<int8, signed char>::value, "the host's int8_t has to agree");

// ---- data vectors

CHECK_SIZE(ODataVectorInfo, 192);
CHECK_OFFSET(ODataVectorInfo, memRegionID, 0);
CHECK_OFFSET(ODataVectorInfo, physAddr, 4);
CHECK_OFFSET(ODataVectorInfo, offset, 8);
CHECK_OFFSET(ODataVectorInfo, totalSize, 12);
CHECK_OFFSET(ODataVectorInfo, type, 16);
CHECK_OFFSET(ODataVectorInfo, infoOffset, 20);
CHECK_OFFSET(ODataVectorInfo, infoSize, 24);
CHECK_OFFSET(ODataVectorInfo, maxNumData, 28);
CHECK_OFFSET(ODataVectorInfo, numData, 32);
CHECK_OFFSET(ODataVectorInfo, syncKey, 36);
CHECK_OFFSET(ODataVectorInfo, wait, 40);
CHECK_OFFSET(ODataVectorInfo, optOffset, 44);
CHECK_OFFSET(ODataVectorInfo, optSize, 48);
CHECK_OFFSET(ODataVectorInfo, padding, 52);
CHECK_OFFSET(ODataVectorInfo, optional, 64);
CHECK_SIZE(OCommandInfo, 32);
CHECK_OFFSET(OCommandInfo, type, 0);
CHECK_OFFSET(OCommandInfo, primitiveID, 4);
CHECK_OFFSET(OCommandInfo, frameNumber, 8);
CHECK_OFFSET(OCommandInfo, numFrames, 12);
CHECK_OFFSET(OCommandInfo, frameSize, 16);
CHECK_OFFSET(OCommandInfo, dataOffset, 20);
CHECK_OFFSET(OCommandInfo, dataSize, 24);
CHECK_OFFSET(OCommandInfo, padding, 28);
CHECK_SIZE(OCommandValue, 8);
CHECK_SIZE(OCommandData, 128);
CHECK_SIZE(OCommandVectorData, 224);
CHECK_OFFSET(OCommandVectorData, vectorInfo, 0);
CHECK_OFFSET(OCommandVectorData, info, 192);
CHECK_SIZE(OJointCommandValue2, 8);
CHECK_OFFSET(OJointCommandValue2, value, 0);
CHECK_OFFSET(OJointCommandValue2, padding, 4);
CHECK_SIZE(OJointCommandValue3, 8);
CHECK_OFFSET(OJointCommandValue3, value, 0);
CHECK_OFFSET(OJointCommandValue3, reserved, 4);
CHECK_OFFSET(OJointCommandValue3, padding, 6);
CHECK_SIZE(OJointCommandValue4, 8);
CHECK_OFFSET(OJointCommandValue4, value, 0);
CHECK_OFFSET(OJointCommandValue4, period, 4);
CHECK_OFFSET(OJointCommandValue4, reserved, 6);
CHECK_SIZE(OLEDCommandValue2, 8);
CHECK_OFFSET(OLEDCommandValue2, led, 0);
CHECK_OFFSET(OLEDCommandValue2, period, 4);
CHECK_OFFSET(OLEDCommandValue2, reserved, 6);
CHECK_SIZE(OLEDCommandValue3, 8);
CHECK_OFFSET(OLEDCommandValue3, intensity, 0);
CHECK_OFFSET(OLEDCommandValue3, mode, 2);
CHECK_OFFSET(OLEDCommandValue3, period, 4);
CHECK_OFFSET(OLEDCommandValue3, reserved, 6);
CHECK_SIZE(OJointCommandValue, 8);
CHECK_OFFSET(OJointCommandValue, value, 0);
CHECK_OFFSET(OJointCommandValue, p, 4);
CHECK_OFFSET(OJointCommandValue, i, 5);
CHECK_OFFSET(OJointCommandValue, d, 6);
CHECK_OFFSET(OJointCommandValue, padding, 7);
CHECK_SIZE(OLEDCommandValue, 8);
CHECK_OFFSET(OLEDCommandValue, led, 0);
CHECK_OFFSET(OLEDCommandValue, period, 4);
CHECK_OFFSET(OLEDCommandValue, padding, 6);
CHECK_SIZE(OCameraCommandValue, 8);
CHECK_OFFSET(OCameraCommandValue, request, 0);
CHECK_OFFSET(OCameraCommandValue, param, 2);
CHECK_SIZE(ORawJointCommandValue, 8);
CHECK_OFFSET(ORawJointCommandValue, signal, 0);
CHECK_SIZE(ORawJointCommandValue2, 8);
CHECK_OFFSET(ORawJointCommandValue2, signal, 0);
CHECK_SIZE(ORawCameraCommandValue, 8);
CHECK_OFFSET(ORawCameraCommandValue, signal, 0);
CHECK_SIZE(ORawLEDCommandValue, 8);
CHECK_OFFSET(ORawLEDCommandValue, signal, 0);
CHECK_SIZE(OSensorFrameInfo, 32);
CHECK_OFFSET(OSensorFrameInfo, type, 0);
CHECK_OFFSET(OSensorFrameInfo, primitiveID, 4);
CHECK_OFFSET(OSensorFrameInfo, frameNumber, 8);
CHECK_OFFSET(OSensorFrameInfo, numFrames, 12);
CHECK_OFFSET(OSensorFrameInfo, frameSize, 16);
CHECK_OFFSET(OSensorFrameInfo, dataOffset, 20);
CHECK_OFFSET(OSensorFrameInfo, dataSize, 24);
CHECK_OFFSET(OSensorFrameInfo, padding, 28);
CHECK_SIZE(OSensorValue, 16);
CHECK_OFFSET(OSensorValue, value, 0);
CHECK_OFFSET(OSensorValue, signal, 4);
CHECK_OFFSET(OSensorValue, padding, 6);
CHECK_SIZE(OAcceleration, 16);
CHECK_OFFSET(OAcceleration, value, 0);
CHECK_OFFSET(OAcceleration, signal, 4);
CHECK_OFFSET(OAcceleration, padding, 6);
CHECK_SIZE(OAngularVelocity, 16);
CHECK_OFFSET(OAngularVelocity, value, 0);
CHECK_OFFSET(OAngularVelocity, signal, 4);
CHECK_OFFSET(OAngularVelocity, padding, 6);
CHECK_SIZE(OTemperature, 16);
CHECK_OFFSET(OTemperature, value, 0);
CHECK_OFFSET(OTemperature, signal, 4);
CHECK_OFFSET(OTemperature, padding, 6);
CHECK_SIZE(OForce, 16);
CHECK_OFFSET(OForce, value, 0);
CHECK_OFFSET(OForce, signal, 4);
CHECK_OFFSET(OForce, padding, 6);
CHECK_SIZE(OPressure, 16);
CHECK_OFFSET(OPressure, value, 0);
CHECK_OFFSET(OPressure, signal, 4);
CHECK_OFFSET(OPressure, padding, 6);
CHECK_SIZE(OLength, 16);
CHECK_OFFSET(OLength, value, 0);
CHECK_OFFSET(OLength, signal, 4);
CHECK_OFFSET(OLength, padding, 6);
CHECK_SIZE(OSwitchStatus, 16);
CHECK_OFFSET(OSwitchStatus, value, 0);
CHECK_OFFSET(OSwitchStatus, signal, 4);
CHECK_OFFSET(OSwitchStatus, padding, 6);
CHECK_SIZE(OJointValue, 16);
CHECK_OFFSET(OJointValue, value, 0);
CHECK_OFFSET(OJointValue, signal, 4);
CHECK_OFFSET(OJointValue, pwmDuty, 6);
CHECK_OFFSET(OJointValue, refValue, 8);
CHECK_OFFSET(OJointValue, refSignal, 12);
CHECK_OFFSET(OJointValue, padding, 14);
CHECK_SIZE(OSensorFrameData, 256);
CHECK_SIZE(OSensorFrameVectorData, 224);
CHECK_OFFSET(OSensorFrameVectorData, vectorInfo, 0);
CHECK_OFFSET(OSensorFrameVectorData, info, 192);
CHECK_SIZE(OFbkImageInfo, 32);
CHECK_OFFSET(OFbkImageInfo, type, 0);
CHECK_OFFSET(OFbkImageInfo, primitiveID, 4);
CHECK_OFFSET(OFbkImageInfo, frameNumber, 8);
CHECK_OFFSET(OFbkImageInfo, dataOffset, 12);
CHECK_OFFSET(OFbkImageInfo, dataSize, 16);
CHECK_OFFSET(OFbkImageInfo, width, 20);
CHECK_OFFSET(OFbkImageInfo, height, 24);
CHECK_OFFSET(OFbkImageInfo, padding, 28);
CHECK_SIZE(OFbkImageVectorData, 224);
CHECK_OFFSET(OFbkImageVectorData, info, 192);
CHECK_SIZE(OCdtInfo, 144);
CHECK_OFFSET(OCdtInfo, type, 0);
CHECK_OFFSET(OCdtInfo, primitiveID, 4);
CHECK_OFFSET(OCdtInfo, channel, 8);
CHECK_OFFSET(OCdtInfo, table, 12);
CHECK_OFFSET(OCdtInfo, padding, 140);
CHECK_SIZE(OCdtVectorData, 1344);
CHECK_OFFSET(OCdtVectorData, info, 192);
CHECK_SIZE(OSoundInfo, 64);
CHECK_OFFSET(OSoundInfo, type, 0);
CHECK_OFFSET(OSoundInfo, primitiveID, 4);
CHECK_OFFSET(OSoundInfo, frameNumber, 8);
CHECK_OFFSET(OSoundInfo, frameSize, 12);
CHECK_OFFSET(OSoundInfo, dataOffset, 16);
CHECK_OFFSET(OSoundInfo, maxDataSize, 20);
CHECK_OFFSET(OSoundInfo, dataSize, 24);
CHECK_OFFSET(OSoundInfo, format, 28);
CHECK_OFFSET(OSoundInfo, channel, 30);
CHECK_OFFSET(OSoundInfo, samplingRate, 32);
CHECK_OFFSET(OSoundInfo, bitsPerSample, 34);
CHECK_OFFSET(OSoundInfo, actualDataSize, 36);
CHECK_OFFSET(OSoundInfo, padding, 40);
CHECK_SIZE(OSoundVectorData, 256);
CHECK_OFFSET(OSoundVectorData, info, 192);
CHECK_SIZE(OSoundSampleStereo16, 4);
CHECK_SIZE(OPrimitiveInfo, 160);
CHECK_OFFSET(OPrimitiveInfo, type, 0);
CHECK_OFFSET(OPrimitiveInfo, primitiveID, 4);
CHECK_OFFSET(OPrimitiveInfo, primitiveType, 8);
CHECK_OFFSET(OPrimitiveInfo, sensorType, 12);
CHECK_OFFSET(OPrimitiveInfo, primitiveStatus, 16);
CHECK_OFFSET(OPrimitiveInfo, padding, 20);
CHECK_OFFSET(OPrimitiveInfo, locator, 32);
CHECK_SIZE(OCPCInfo, 12);
CHECK_OFFSET(OCPCInfo, type, 0);
CHECK_OFFSET(OCPCInfo, cpcClass, 4);
CHECK_OFFSET(OCPCInfo, cpcSubClass, 6);
CHECK_OFFSET(OCPCInfo, cpcType, 8);
CHECK_OFFSET(OCPCInfo, numReceptors, 10);
CHECK_SIZE(OVRData, 16);
CHECK_SIZE(OCPUInfo, 256);

// Two sizes that the Level 2 Reference Guide computes: for 12 joints, and for the 31 sensors of the
// ERS-210.
static_assert(sizeof(ODataVectorInfo) + 12 * (sizeof(OCommandInfo) + sizeof(OCommandData)) == 2112,
              "command vector of 12");
static_assert(sizeof(ODataVectorInfo) +
                      31 * (sizeof(OSensorFrameInfo) + sizeof(OSensorFrameData)) ==
                  9120,
              "sensor vector of 31");

// ---- power, messages, archives, wireless card

CHECK_SIZE(OPowerStatus, 20);
CHECK_OFFSET(OPowerStatus, robotStatus, 0);
CHECK_OFFSET(OPowerStatus, batteryStatus, 4);
CHECK_OFFSET(OPowerStatus, remainingCapacity, 6);
CHECK_OFFSET(OPowerStatus, temperature, 8);
CHECK_OFFSET(OPowerStatus, fullyChargedCapacity, 10);
CHECK_OFFSET(OPowerStatus, voltage, 12);
CHECK_OFFSET(OPowerStatus, current, 14);
CHECK_OFFSET(OPowerStatus, timeDif, 16);
CHECK_OFFSET(OPowerStatus, volume, 17);
CHECK_SIZE(OReasonMessage, 140);
CHECK_OFFSET(OReasonMessage, msgType, 0);
CHECK_OFFSET(OReasonMessage, reason, 4);
CHECK_OFFSET(OReasonMessage, paramSize, 8);
CHECK_OFFSET(OReasonMessage, param, 12);
CHECK_SIZE(OStatusMessage, 8);
CHECK_SIZE(OPowerStatusMessage, 24);
CHECK_OFFSET(OPowerStatusMessage, powerStatus, 4);
CHECK_SIZE(OPrimitiveControl_SpeakerVolume, 4);
CHECK_SIZE(OPrimitiveControl_SpeakerSoundType, 4);
CHECK_SIZE(OPrimitiveControl_CameraParam, 4);
CHECK_SIZE(OPrimitiveControl_Cdt, 104);
CHECK_SIZE(OPrimitiveControl_MasterTuningMIDI, 2);
static_assert(sizeof(OPrimitiveControl_Cdt) <= oprmctrlPARAM_MAX_SIZE, "parameter block");
CHECK_SIZE(ODataArchive::Header, 64);
CHECK_SIZE(ODataArchive::Entry, 144);
CHECK_SIZE(IPAddress, 4);
CHECK_SIZE(EtherDriverGetMACAddressMsg, 16);
CHECK_OFFSET(EtherDriverGetMACAddressMsg, port, 0);
CHECK_OFFSET(EtherDriverGetMACAddressMsg, address, 4);
CHECK_OFFSET(EtherDriverGetMACAddressMsg, status, 12);
CHECK_SIZE(EtherDriverGetStatisticsMsg, 44);
CHECK_OFFSET(EtherDriverGetStatisticsMsg, statistics, 4);
CHECK_OFFSET(EtherDriverGetStatisticsMsg, status, 40);
CHECK_SIZE(EtherDriverGetWLANSettingsMsg, 104);
CHECK_OFFSET(EtherDriverGetWLANSettingsMsg, port, 0);
CHECK_OFFSET(EtherDriverGetWLANSettingsMsg, mode, 4);
CHECK_OFFSET(EtherDriverGetWLANSettingsMsg, essid, 8);
CHECK_OFFSET(EtherDriverGetWLANSettingsMsg, stationName, 41);
CHECK_OFFSET(EtherDriverGetWLANSettingsMsg, channel, 76);
CHECK_OFFSET(EtherDriverGetWLANSettingsMsg, encryption, 80);
CHECK_OFFSET(EtherDriverGetWLANSettingsMsg, rate, 84);
CHECK_OFFSET(EtherDriverGetWLANSettingsMsg, rts, 88);
CHECK_OFFSET(EtherDriverGetWLANSettingsMsg, fragmentation, 92);
CHECK_OFFSET(EtherDriverGetWLANSettingsMsg, sensitivity, 96);
CHECK_OFFSET(EtherDriverGetWLANSettingsMsg, status, 100);
CHECK_SIZE(EtherDriverGetWLANStatisticsMsg, 24);
CHECK_OFFSET(EtherDriverGetWLANStatisticsMsg, statistics, 4);
CHECK_OFFSET(EtherDriverGetWLANStatisticsMsg, status, 20);

#endif  // TESTS_RUNTIME_INCLUDE_LAYOUT_CHECKS_H
