// Names of the services of the robot's hardware.
//
// The names are written in CONNECT.CFG; a program that uses only its own services does not need
// them.
#ifndef OPENR_OPENRSERVICES_H_INCLUDED
#define OPENR_OPENRSERVICES_H_INCLUDED

const char* const ovrcommSENSOR = "OVirtualRobotComm.Sensor.OSensorFrameVectorData.S";
const char* const ovrcommEFFECTOR = "OVirtualRobotComm.Effector.OCommandVectorData.O";
const char* const ovrcommFBK = "OVirtualRobotComm.FbkImageSensor.OFbkImageVectorData.S";
const char* const ovrcommMIC = "OVirtualRobotAudioComm.Mic.OSoundVectorData.S";
const char* const ovrcommSPEAKER = "OVirtualRobotAudioComm.Speaker.OSoundVectorData.O";
const char* const ovrcommALERT = "OVirtualRobotComm.Alert.OPrimitiveMapData.S";  // obsolete

#endif  // OPENR_OPENRSERVICES_H_INCLUDED
