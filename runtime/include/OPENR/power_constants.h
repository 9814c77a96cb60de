// Bits and special values of OPowerStatus and OBootCondition.
#ifndef OPENR_POWER_CONSTANTS_H_INCLUDED
#define OPENR_POWER_CONSTANTS_H_INCLUDED

#include <Types.h>

// ---- bits of OPowerStatus::robotStatus

const longword orsbPAUSE = 0x00000001;  // the pause switch is on
const longword orsbMOTOR_POWER = 0x00000002;
const longword orsbVIBRATION_DETECT = 0x00000004;
const longword orsbEX_PORT_CONNECTED = 0x00000008;
const longword orsbSTATION_CONNECTED = 0x00000010;
const longword orsbEX_POWER_CONNECTED = 0x00000020;
const longword orsbBATTERY_CONNECTED = 0x00000040;
const longword orsbBATTERY_CHARGING = 0x00000080;
const longword orsbBATTERY_CAPACITY_FULL = 0x00000100;
const longword orsbBATTERY_CAPACITY_LOW = 0x00000200;
const longword orsbBATTERY_OVER_CURRENT = 0x00000400;
const longword orsbBATTERY_OVER_TEMP_DISCHARGING = 0x00000800;
const longword orsbBATTERY_OVER_TEMP_CHARGING = 0x00001000;
const longword orsbBATTERY_ERROR_OF_CHARGING = 0x00002000;
const longword orsbERROR_OF_PLUNGER = 0x00004000;
const longword orsbOPEN_R_POWER_GOOD = 0x00008000;
const longword orsbERROR_OF_FAN = 0x00010000;
const longword orsbDATA_STREAM_FROM_STATION = 0x00020000;
const longword orsbREGISTER_UPDATED_BY_STATION = 0x00040000;
const longword orsbRTC_ERROR = 0x00080000;
const longword orsbRTC_OVERFLOW = 0x00100000;
const longword orsbRTC_RESET = 0x00200000;
const longword orsbRTC_SET = 0x00400000;  // the robot reports this bit once and then clears it
const longword orsbSPECIAL_MODE = 0x00800000;
const longword orsbBMN_DEBUG_MODE = 0x01000000;
const longword orsbCHARGER_STATUS = 0x02000000;
const longword orsbPLUNGER = 0x04000000;  // the battery is locked in
const longword orsbSUSPENDED = 0x08000000;
const longword orsbSPECIAL_DATA_READ_REQ = 0x10000000;
const longword orsbALL = 0x1fffffff;

// ---- bits and error codes of OPowerStatus::batteryStatus

const word obsbERROR_CODE_MASK = 0x000f;  // mask of the bits with the error code obsec...
const word obsbFULLY_DISCHARGED = 0x0010;
const word obsbFULLY_CHARGED = 0x0020;
const word obsbDISCHARGING = 0x0040;
const word obsbINITIALIZED = 0x0080;  // always set
const word obsbREMAINING_TIME_ALARM = 0x0100;
const word obsbREMAINING_CAPACITY_ALARM = 0x0200;
const word obsbRESERVED0 = 0x0400;
const word obsbTERMINATED_DISCHARGING_ALARM = 0x0800;
const word obsbOVER_TEMP_ALARM = 0x1000;
const word obsbRESERVED1 = 0x2000;
const word obsbTERMINATED_CHARGING_ALARM = 0x4000;
const word obsbOVER_CHARGED_ALARM = 0x8000;
const word obsbALL = 0xffff;

const longword obsecOK = 0;
const longword obsecBUSY = 1;
const longword obsecNOT_READY = 2;
const longword obsecUNSUPPORTED_COMMAND = 3;
const longword obsecACCESS_DENIED = 4;
const longword obsecOVER_OR_UNDER_FLOW = 5;
const longword obsecBAD_SIZE = 6;
const longword obsecUNKNOWN = 7;

// ---- fields of the filter of OPENR::ObservePowerStatus()
//
// Each bit that is set in robotStatus and batteryStatus of the filter requests a message whenever
// this bit of the status changes.  For each of the four numbers (remainingCapacity, temperature,
// timeDif, volume), one constant below requests a message for every change, and one requests no
// message.  Any other number in the filter requests a message when the status reaches this number.
// Voltage, current and full capacity cannot be observed.

const word opsoREMAINING_CAPACITY_NOTIFY_EVERY_CHANGE = 0xffff;
const word opsoREMAINING_CAPACITY_NOT_NOTIFY = 0xfffe;
const word opsoTEMPERATURE_NOTIFY_EVERY_CHANGE = 0xffff;
const word opsoTEMPERATURE_NOT_NOTIFY = 0xfffe;
const sbyte opsoTIME_DIF_NOTIFY_EVERY_CHANGE = 0x7f;
const sbyte opsoTIME_DIF_NOT_NOTIFY = 0x7e;
const byte opsoVOLUME_NOTIFY_EVERY_CHANGE = 0xff;
const byte opsoVOLUME_NOT_NOTIFY = 0xfe;

// ---- bits of OBootCondition::bitmap

const word obcbBOOT_TIMER = 0x0001;
const word obcbVIBRATION_DETECTED = 0x0002;
const word obcbPAUSE_SW = 0x0004;  // the pause button
const word obcbSTATION_CONNECTED = 0x0008;
const word obcbSTATION_DISCONNECTED = 0x0010;
const word obcbBATTERY_CAPACITY_FULL = 0x0020;
const word obcbREQ_FROM_STATION = 0x0040;
const word obcbALL = 0x007f;

// ---- values of OBootCondition::bootTimeType

const longword obcbttRELATIVE = 0;
const longword obcbttABSOLUTE = 0x80000000;

// ---- numbers of the data streams of the robot's charging station; no function of these
// headers uses the numbers

const byte odstSOUND = 0;
const byte odstLCD = 1;
const byte odstSTATION_WRITE = 2;
const byte odstSTATION_READ = 3;
const byte odstBATTERY_DEVICE_NAME = 4;
const byte odstSPECIAL_DATA = 5;

#endif  // OPENR_POWER_CONSTANTS_H_INCLUDED
