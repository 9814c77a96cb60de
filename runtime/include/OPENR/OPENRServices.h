// Names of the services of the objects that control the robot's hardware.
//
// CONNECT.CFG contains these names as text, so most programs do not need the constants.
#ifndef OPENR_OPENRSERVICES_H_INCLUDED
#define OPENR_OPENRSERVICES_H_INCLUDED

const char* const ovrcommSENSOR = "OVirtualRobotComm.Sensor.OSensorFrameVectorData.S";
const char* const ovrcommEFFECTOR = "OVirtualRobotComm.Effector.OCommandVectorData.O";
const char* const ovrcommFBK = "OVirtualRobotComm.FbkImageSensor.OFbkImageVectorData.S";
const char* const ovrcommMIC = "OVirtualRobotAudioComm.Mic.OSoundVectorData.S";
const char* const ovrcommSPEAKER = "OVirtualRobotAudioComm.Speaker.OSoundVectorData.O";
const char* const ovrcommALERT = "OVirtualRobotComm.Alert.OPrimitiveMapData.S";  // obsolete

#endif  // OPENR_OPENRSERVICES_H_INCLUDED
