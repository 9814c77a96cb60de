// Names of the services through which the robot's hardware is reached.
//
// They are meant for CONNECT.CFG; a program that only uses its own services needs none.
#ifndef OPENR_OPENRSERVICES_H_INCLUDED
#define OPENR_OPENRSERVICES_H_INCLUDED

const char* const ovrcommSENSOR = "OVirtualRobotComm.Sensor.OSensorFrameVectorData.S";
const char* const ovrcommEFFECTOR = "OVirtualRobotComm.Effector.OCommandVectorData.O";
const char* const ovrcommFBK = "OVirtualRobotComm.FbkImageSensor.OFbkImageVectorData.S";
const char* const ovrcommMIC = "OVirtualRobotAudioComm.Mic.OSoundVectorData.S";
const char* const ovrcommSPEAKER = "OVirtualRobotAudioComm.Speaker.OSoundVectorData.O";
const char* const ovrcommALERT = "OVirtualRobotComm.Alert.OPrimitiveMapData.S";  // obsolete

#endif  // OPENR_OPENRSERVICES_H_INCLUDED
