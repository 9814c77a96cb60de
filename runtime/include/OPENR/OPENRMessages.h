// Messages between the system and an object.
//
// An application receives only OPowerStatusMessage, and its stub receives only OReasonMessage and
// OConnectMessage.  On the robot the OPENR:: functions send the other messages.  On the host they
// send no messages; the structs are declared because sources of old programs name them.  Sizes are
// those of a 32-bit target, as on the robot.
#ifndef OPENR_OPENRMESSAGES_H_INCLUDED
#define OPENR_OPENRMESSAGES_H_INCLUDED

#include <OPENR/MWInformationTypes.h>
#include <OPENR/ODataFormats.h>
#include <OPENR/OPENR.h>
#include <OPENR/OPower.h>
#include <OPENR/OSyslog.h>
#include <OPENR/OTime.h>
#include <OPENR/OVRData.h>
#include <string.h>

// The type of a message of OPEN-R, a number.  The number only describes the bytes of the message;
// the selector decides which function receives the message.  So a message between objects
// (ObjcommMessages.h) may have the same number as a message of the system.
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

// ---- messages that objects receive or send

// The message to the entries Init, Start, Stop and Destroy of an object; 140 bytes.
struct OReasonMessage {
  OMessageType msgType;  // omsgREASON
  OReason reason;
  longword paramSize;  // number of bytes of `param` in use
  byte param[oreasonPARAM_MAX_SIZE];

  OReasonMessage(OReason why = oreasonUNDEF) { Set(why, 0, 0); }

  // Copies the parameter of DoInit, DoStart, DoStop or DoDestroy into this message: the `size`
  // bytes at `block`, or only the first oreasonPARAM_MAX_SIZE bytes if `size` is larger.
  OReasonMessage(OReason why, const void* block, size_t size) { Set(why, block, size); }

 private:
  void Set(OReason why, const void* block, size_t size) {
    msgType = omsgREASON;
    reason = why;
    paramSize = static_cast<longword>(size < sizeof param ? size : sizeof param);
    memset(param, 0, sizeof param);
    if (paramSize != 0) memcpy(param, block, paramSize);
  }
};

// An answer that contains only a status; 8 bytes.
struct OStatusMessage {
  OMessageType msgType;  // omsgOSTATUS
  OStatus status;

  OStatusMessage(OStatus result = oSUCCESS) : msgType(omsgOSTATUS), status(result) {}
};

// The message to the entry that was given to OPENR::ObservePowerStatus(); 24 bytes.
struct OPowerStatusMessage {
  OMessageType msgType;  // omsgPOWER_STATUS
  OPowerStatus powerStatus;

  OPowerStatusMessage() : msgType(omsgPOWER_STATUS) {}
  OPowerStatusMessage(const OPowerStatus& status)
      : msgType(omsgPOWER_STATUS), powerStatus(status) {}
  OPowerStatusMessage(longword robotStatus, word batteryStatus, word remainingCapacity,
                      word temperature, word fullyChargedCapacity, word voltage, word current,
                      sbyte timeDif, word volume)
      : msgType(omsgPOWER_STATUS),
        powerStatus(robotStatus, batteryStatus, remainingCapacity, temperature,
                    fullyChargedCapacity, voltage, static_cast<sword>(current), timeDif,
                    static_cast<byte>(volume)) {}
};

// A message to the robot's system logger; 256 bytes on the robot, more on the host, where an OID
// has 8 bytes.
struct OSyslogMessage {
  OMessageType msgType;  // omsgSYSLOG
  OID oid;               // the object that logs
  OSyslogPriority priority;
  char log[osyslogMAX_SIZE + 1];

  OSyslogMessage() : msgType(omsgSYSLOG), priority(osyslogINFO) { memset(log, 0, sizeof log); }
};

// The object manager sends this message to an observer, which must then connect to the subject
// whose Control entry is `entry`, or disconnect from it, as `command` says.
struct OConnectMessage {
  OMessageType msgType;  // omsgCONNECT
  OConnectCmd command;
  OServiceEntry entry;
  char subName[oserviceNAME_MAX + 1];

  OConnectMessage(OConnectCmd what = oconnectcmdCONNECT) : msgType(omsgCONNECT), command(what) {
    memset(subName, 0, sizeof subName);
  }
};

// ---- messages of the system, in the order of their numbers

struct ONullMessage {
  OMessageType msgType;  // omsgNULL
};

struct OsErrorMessage {
  OMessageType msgType;  // omsgSYS_ERROR
  sError error;
};

struct OOIDMessage {
  OMessageType msgType;  // omsgOID
  OID oid;
};

struct OSystemObjectInfoMessage {
  OMessageType msgType;  // omsgSYSOBJ_INFO
  OID oid;
  char name[oobjectNAME_MAX + 1];
};

struct OServiceNameMessage {
  OMessageType msgType;  // omsgSERVICE_NAME
  char name[oserviceNAME_MAX + 1];
  OID oid;
};

struct OServiceEntryMessage {
  OMessageType msgType;  // omsgSERVICE_ENTRY
  OServiceEntry entry;
};

struct OServiceBindingMessage {
  OMessageType msgType;  // omsgSERVICE_BINDING
  OServiceEntry entry;
  char name[oserviceNAME_MAX + 1];
};

struct OMemoryRegionIDMessage {
  OMessageType msgType;  // omsgMEMORY_REGION_ID
  MemoryRegionID memID;
  OStatus status;
};

struct OMWInfoIDMessage {
  OMessageType msgType;  // omsgMWINFO_ID
  MWIID mwiID;
  OStatus status;
};

struct ORobotDesignMessage {
  OMessageType msgType;  // omsgROBOT_DESIGN
  char robotDesign[orobotdesignNAME_MAX + 1];
  OStatus status;
};

struct ODesignKeywordMessage {
  OMessageType msgType;  // omsgDESIGN_KEYWORD
  char keyword[odesignkeywordNAME_MAX + 1];
};

struct ODesignDataMessage {
  OMessageType msgType;  // omsgDESIGN_DATA
  ODesignDataID dataID;
  unsigned int size;  // in bytes
  OStatus status;
};

struct OFatalMessage {
  OMessageType msgType;  // omsgFATAL
  OFatal fatal;
};

struct OMemoryStickStatusMessage {
  OMessageType msgType;  // omsgMEMORY_STICK
  OMemoryStickStatus status;
};

struct OPrimitiveLocatorMessage {
  OMessageType msgType;  // omsgPRIMITIVE_LOCATOR
  char locator[ovrPATH_MAX + 1];
};

struct OPrimitiveIDMessage {
  OMessageType msgType;  // omsgPRIMITIVE_ID
  OStatus status;
  OPrimitiveID primitiveID;
};

struct OVRDataMessage {
  OMessageType msgType;  // omsgVR_DATA
  OServiceEntry entry;
  OAsyncReqID asyncReqID;
  unsigned int numData;
  OVRData data[ovrdataMAX_SIZE];
};

struct OVRControlMessage {
  OMessageType msgType;  // omsgVR_CONTROL
  OStatus status;
  OVRRequest request;
  OServiceEntry entry;
  OAsyncReqID asyncReqID;
  unsigned int paramSize;  // number of bytes of `param` in use
  longword padding;
  byte param[ovrctrlPARAM_MAX_SIZE];
};

struct OTimeMessage {
  OMessageType msgType;  // omsgTIME
  OTime time;
};

struct OMotorPowerMessage {
  OMessageType msgType;  // omsgMOTOR_POWER
  OPower motorPower;
};

struct OPlungerMessage {
  OMessageType msgType;  // omsgPLUNGER
  bool plunger;
};

struct OAlarmMessage {
  OMessageType msgType;  // omsgALARM
  OTime alarmTime;
  OServiceEntry entry;
};

struct OObservePowerStatusMessage {
  OMessageType msgType;  // omsgOBSERVE_POWER_STATUS
  OServiceEntry entry;
  OPowerStatus notifyStatus;
};

struct OVolumeMessage {
  OMessageType msgType;  // omsgVOLUME
  OVolumeSwitch volume;
};

struct OBmnDataStreamMessage {
  OMessageType msgType;  // omsgBMN_DATA_STREAM
  byte dataType;
  MemoryRegionID memID;
  longword offset;  // in bytes
  longword length;  // in bytes
  OServiceEntry entry;
};

struct OStationRegisterMessage {
  OMessageType msgType;  // omsgSTATION_REGISTER
  OStatus status;
  byte addr;
  longword data;
};

struct OBootConditionMessage {
  OMessageType msgType;  // omsgBOOT_CONDITION
  OBootCondition bootCondition;
};

struct OBmnModeMessage {
  OMessageType msgType;  // omsgBMN_MODE
  word bmnMode;
};

struct OBmnSpecialModeMessage {
  OMessageType msgType;  // omsgBMN_SPECIAL_MODE
  byte bmnSpecialMode;
};

#endif  // OPENR_OPENRMESSAGES_H_INCLUDED
