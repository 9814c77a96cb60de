// Messages between the system and an object.
//
// An application sees one of them, OPowerStatusMessage; its stub sees OReasonMessage.
#ifndef OPENR_OPENRMESSAGES_H_INCLUDED
#define OPENR_OPENRMESSAGES_H_INCLUDED

#include <OPENR/MWInformationTypes.h>
#include <OPENR/ODataFormats.h>
#include <OPENR/OPENR.h>
#include <OPENR/OPower.h>
#include <OPENR/OSyslog.h>
#include <OPENR/OTime.h>
#include <OPENR/OVRData.h>

// Dispatch is by selector; the type only says what the bytes are.  The numbers of the
// inter-object messages (ObjcommMessages.h) overlap with these.
typedef longword OMessageType;
const OMessageType OMessageSystemBase = 0;
const OMessageType OMessageRoboticBase = 1024;

const OMessageType omsgNULL = OMessageSystemBase + 0;
const OMessageType omsgSYS_ERROR = OMessageSystemBase + 1;
const OMessageType omsgOSTATUS = OMessageSystemBase + 2;
const OMessageType omsgREASON = OMessageSystemBase + 3;
const OMessageType omsgOID = OMessageSystemBase + 4;
const OMessageType omsgSYSOBJ_INFO = OMessageSystemBase + 5;
const OMessageType omsgCONNECT = OMessageSystemBase + 6;
const OMessageType omsgSERVICE_NAME = OMessageSystemBase + 7;
const OMessageType omsgSERVICE_ENTRY = OMessageSystemBase + 8;
const OMessageType omsgSERVICE_BINDING = OMessageSystemBase + 9;
const OMessageType omsgMEMORY_REGION_ID = OMessageSystemBase + 10;
const OMessageType omsgMWINFO_ID = OMessageSystemBase + 11;
const OMessageType omsgSYSLOG = OMessageSystemBase + 12;
const OMessageType omsgROBOT_DESIGN = OMessageSystemBase + 13;
const OMessageType omsgDESIGN_KEYWORD = OMessageSystemBase + 14;
const OMessageType omsgDESIGN_DATA = OMessageSystemBase + 15;
const OMessageType omsgFATAL = OMessageSystemBase + 16;
const OMessageType omsgMEMORY_STICK = OMessageSystemBase + 17;

const OMessageType omsgPRIMITIVE_LOCATOR = OMessageRoboticBase + 0;
const OMessageType omsgPRIMITIVE_ID = OMessageRoboticBase + 1;
const OMessageType omsgVR_DATA = OMessageRoboticBase + 2;
const OMessageType omsgVR_CONTROL = OMessageRoboticBase + 3;
const OMessageType omsgTIME = OMessageRoboticBase + 4;
const OMessageType omsgPOWER_MODE = OMessageRoboticBase + 5;
const OMessageType omsgPOWER_STATUS = OMessageRoboticBase + 6;
const OMessageType omsgMOTOR_POWER = OMessageRoboticBase + 7;
const OMessageType omsgPLUNGER = OMessageRoboticBase + 8;
const OMessageType omsgALARM = OMessageRoboticBase + 9;
const OMessageType omsgOBSERVE_POWER_STATUS = OMessageRoboticBase + 10;
const OMessageType omsgVOLUME = OMessageRoboticBase + 11;
const OMessageType omsgBMN_DATA_STREAM = OMessageRoboticBase + 12;
const OMessageType omsgSTATION_REGISTER = OMessageRoboticBase + 13;
const OMessageType omsgBOOT_CONDITION = OMessageRoboticBase + 14;
const OMessageType omsgBMN_MODE = OMessageRoboticBase + 15;
const OMessageType omsgBMN_SPECIAL_MODE = OMessageRoboticBase + 16;

// To the entries Init, Start, Stop and Destroy; 140 bytes.
struct OReasonMessage {
  OMessageType msgType;  // omsgREASON
  OReason reason;
  longword paramSize;  // bytes used of `param`
  byte param[oreasonPARAM_MAX_SIZE];
};

// An answer that is nothing but a status; 8 bytes.
struct OStatusMessage {
  OMessageType msgType;  // omsgOSTATUS
  OStatus status;
};

// To the entry given to OPENR::ObservePowerStatus(); 24 bytes.
struct OPowerStatusMessage {
  OMessageType msgType;  // omsgPOWER_STATUS
  OPowerStatus powerStatus;
};

// To the system logger; 256 bytes on the robot.  The order of the fields is inferred.
struct OSyslogMessage {
  OMessageType msgType;  // omsgSYSLOG
  OSyslogPriority priority;
  OID oid;  // who says it
  char text[osyslogMAX_SIZE + 1];
};

#endif  // OPENR_OPENRMESSAGES_H_INCLUDED
