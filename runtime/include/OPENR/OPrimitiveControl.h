// Requests of OPENR::ControlPrimitive() with their parameters and results.
//
// The names of the camera's settings, of the fields of the direct-command structs, and of
// the structs for MIDI tuning and the Bluetooth switch are in no source we have.
#ifndef OPENR_OPRIMITIVECONTROL_H_INCLUDED
#define OPENR_OPRIMITIVECONTROL_H_INCLUDED

#include <OPENR/ODataFormats.h>
#include <OPENR/OPENR.h>

// ---- speaker

const OPrimitiveRequest oprmreqSPEAKER_MUTE_ON = 128;
const OPrimitiveRequest oprmreqSPEAKER_MUTE_OFF = 129;
const OPrimitiveRequest oprmreqSPEAKER_SET_VOLUME = 130;      // SpeakerVolume
const OPrimitiveRequest oprmreqSPEAKER_SET_SOUND_TYPE = 131;  // SpeakerSoundType
const OPrimitiveRequest oprmreqSPEAKER_GET_SOUND_TYPE = 132;  // result: SpeakerSoundType
const OPrimitiveRequest oprmreqSPEAKER_SET_VOLUME_MIDI = 133;
const OPrimitiveRequest oprmreqSPEAKER_MASTER_TUNING_MIDI = 134;  // MasterTuningMIDI

// Volume in two's complement of 16 bits, 0x100 per dB.
const longword ospkvolinfdB = 0x8000;  // silent
const longword ospkvol25dB = 0xe700;   // -25 dB
const longword ospkvol18dB = 0xee00;
const longword ospkvol10dB = 0xf600;  // the loudest the circuit is made for

struct OPrimitiveControl_SpeakerVolume {
  longword volume;
  OPrimitiveControl_SpeakerVolume(longword v) : volume(v) {}
};

const longword ospksndMONO8K8B = 0;    // 8 kHz, 8 bits: the default
const longword ospksndMONO16K16B = 3;  // 16 kHz, 16 bits

struct OPrimitiveControl_SpeakerSoundType {
  longword type;
  OPrimitiveControl_SpeakerSoundType(longword t) : type(t) {}
};

struct OPrimitiveControl_MasterTuningMIDI {
  sword value;
  OPrimitiveControl_MasterTuningMIDI(sword v) : value(v) {}
};

// ---- microphone: directional or not, automatic level control

const OPrimitiveRequest oprmreqMIC_UNI = 256;
const OPrimitiveRequest oprmreqMIC_OMNI = 257;
const OPrimitiveRequest oprmreqMIC_ALC_ON = 258;
const OPrimitiveRequest oprmreqMIC_ALC_OFF = 259;

// ---- camera

const OPrimitiveRequest oprmreqCAM_SET_WHITE_BALANCE = 384;  // CameraParam
const OPrimitiveRequest oprmreqCAM_SET_GAIN = 385;           // CameraParam
const OPrimitiveRequest oprmreqCAM_SET_SHUTTER_SPEED = 386;  // CameraParam
const OPrimitiveRequest oprmreqCAM_GET_CDT_TABLE = 387;      // parameter and result: Cdt
const OPrimitiveRequest oprmreqCAM_AE_ON = 388;              // automatic exposure
const OPrimitiveRequest oprmreqCAM_AE_OFF = 389;
const OPrimitiveRequest oprmreqCAM_AWB_ON = 390;  // automatic white balance
const OPrimitiveRequest oprmreqCAM_AWB_OFF = 391;

const longword ocamparamWB_INDOOR_MODE = 1;   // 2800 K
const longword ocamparamWB_OUTDOOR_MODE = 2;  // 7000 K
const longword ocamparamWB_FL_MODE = 3;       // fluorescent, 4300 K: the default
const longword ocamparamGAIN_LOW = 1;         // 0 dB
const longword ocamparamGAIN_MID = 2;         // 0 dB
const longword ocamparamGAIN_HIGH = 3;        // 6 dB
const longword ocamparamSHUTTER_SLOW = 1;     // 1/50 s
const longword ocamparamSHUTTER_MID = 2;      // 1/100 s: the default
const longword ocamparamSHUTTER_FAST = 3;     // 1/200 s

struct OPrimitiveControl_CameraParam {
  longword param;
  OPrimitiveControl_CameraParam(longword p) : param(p) {}
};

struct OPrimitiveControl_Cdt {
  longword index;
  byte table[100];
};

// ---- Bluetooth

const OPrimitiveRequest oprmreqBT_ATTACH = 512;
const OPrimitiveRequest oprmreqBT_DETACH = 513;
const OPrimitiveRequest oprmreqSENSOR_WATCH_BT_SWITCH = 896;  // WatchBTSwitch

struct OPrimitiveControl_WatchBTSwitch {
  longword event;
  OServiceEntry entry;
};

// ---- commands and readings without a vector

const OPrimitiveRequest oprmreqJOINT2_SET_COMMAND = 640;   // JointCommandValue2
const OPrimitiveRequest oprmreqJOINT2_GET_VALUE = 641;     // result: JointValue
const OPrimitiveRequest oprmreqLED2_SET_COMMAND = 768;     // LEDCommandValue2
const OPrimitiveRequest oprmreqLED3_SET_COMMAND = 1024;    // LEDCommandValue3
const OPrimitiveRequest oprmreqJOINT4_SET_COMMAND = 1152;  // JointCommandValue4

struct OPrimitiveControl_JointCommandValue2 {
  slongword value;  // 10^-6 rad
  OPrimitiveControl_JointCommandValue2(slongword v) : value(v) {}
};

struct OPrimitiveControl_JointValue {
  OJointValue value;
};

struct OPrimitiveControl_LEDCommandValue2 {
  OLEDValue led;
  word period;
  OPrimitiveControl_LEDCommandValue2(OLEDValue l) : led(l), period(0) {}
};

struct OPrimitiveControl_LEDCommandValue3 {
  sword intensity;
  OLED3Mode mode;
  word period;
  OPrimitiveControl_LEDCommandValue3(sword i, OLED3Mode m) : intensity(i), mode(m), period(0) {}
};

struct OPrimitiveControl_JointCommandValue4 {
  OJointValue4 value;
  word period;
  OPrimitiveControl_JointCommandValue4(OJointValue4 v) : value(v), period(1) {}
};

// Requests from here on are the device makers' own.
const OPrimitiveRequest oprmreqPRIVATE_BASE = 1048576;

#endif  // OPENR_OPRIMITIVECONTROL_H_INCLUDED
