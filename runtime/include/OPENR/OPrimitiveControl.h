// Requests of OPENR::ControlPrimitive() with their parameters and results.
//
// A trailing comment such as "parameter: Cdt" means that the parameter of the request is a struct
// OPrimitiveControl_Cdt.  The names of the camera's settings and of the struct for MIDI tuning are
// our choice, because no source gives their names.
#ifndef OPENR_OPRIMITIVECONTROL_H_INCLUDED
#define OPENR_OPRIMITIVECONTROL_H_INCLUDED

#include <OPENR/ODataFormats.h>
#include <OPENR/OPENR.h>

// For each kind of primitive, the lowest number of its requests to OPENR::ControlPrimitive().
// Requests for all kinds begin at oprmreqCOMMON_BASE.
const OPrimitiveRequest oprmreqCOMMON_BASE = 0;
const OPrimitiveRequest oprmreqSPEAKER_BASE = 128;
const OPrimitiveRequest oprmreqMIC_BASE = 256;
const OPrimitiveRequest oprmreqCAM_BASE = 384;
const OPrimitiveRequest oprmreqBT_BASE = 512;
const OPrimitiveRequest oprmreqJOINT2_BASE = 640;
const OPrimitiveRequest oprmreqLED2_BASE = 768;
const OPrimitiveRequest oprmreqSENSOR_BASE = 896;
const OPrimitiveRequest oprmreqLED3_BASE = 1024;
const OPrimitiveRequest oprmreqJOINT4_BASE = 1152;

// ---- speaker

const OPrimitiveRequest oprmreqSPEAKER_MUTE_ON = 128;
const OPrimitiveRequest oprmreqSPEAKER_MUTE_OFF = 129;
const OPrimitiveRequest oprmreqSPEAKER_SET_VOLUME = 130;      // parameter: SpeakerVolume
const OPrimitiveRequest oprmreqSPEAKER_SET_SOUND_TYPE = 131;  // parameter: SpeakerSoundType
const OPrimitiveRequest oprmreqSPEAKER_GET_SOUND_TYPE = 132;  // result: SpeakerSoundType
const OPrimitiveRequest oprmreqSPEAKER_SET_VOLUME_MIDI = 133;
const OPrimitiveRequest oprmreqSPEAKER_MASTER_TUNING_MIDI = 134;  // parameter: MasterTuningMIDI

// A volume in dB: a two's complement number of 16 bits, in which 0x100 is 1 dB.  The volumes below
// are negative; 0 is louder than all of them.
typedef longword OSpeakerVolume;
const OSpeakerVolume ospkvolinfdB = 0x8000;  // makes the speaker silent
const OSpeakerVolume ospkvol25dB = 0xe700;   // -25 dB
const OSpeakerVolume ospkvol18dB = 0xee00;
const OSpeakerVolume ospkvol10dB = 0xf600;  // -10 dB; louder volumes may damage the robot's circuit

struct OPrimitiveControl_SpeakerVolume {
  OSpeakerVolume volume;
  OPrimitiveControl_SpeakerVolume(OSpeakerVolume v) : volume(v) {}
};

// The formats of sound that oprmreqSPEAKER_SET_SOUND_TYPE can request.  The ERS-210 accepts only
// ospksndMONO8K8B and ospksndMONO16K16B.
typedef longword OSpeakerSoundType;
const OSpeakerSoundType ospksndMONO8K8B = 0;  // 8 kHz, 8 bits: the default
const OSpeakerSoundType ospksndMONO11K8B = 1;
const OSpeakerSoundType ospksndMONO16K8B = 2;
const OSpeakerSoundType ospksndMONO16K16B = 3;  // 16 kHz, 16 bits
const OSpeakerSoundType ospksndSTEREO16K16B = 4;

struct OPrimitiveControl_SpeakerSoundType {
  OSpeakerSoundType type;
  OPrimitiveControl_SpeakerSoundType(OSpeakerSoundType t) : type(t) {}
};

struct OPrimitiveControl_MasterTuningMIDI {
  sword value;
  OPrimitiveControl_MasterTuningMIDI(sword v) : value(v) {}
};

// ---- requests to the microphone: record from one direction (UNI) or from all directions (OMNI),
// switch automatic level control (ALC) on or off

const OPrimitiveRequest oprmreqMIC_UNI = 256;
const OPrimitiveRequest oprmreqMIC_OMNI = 257;
const OPrimitiveRequest oprmreqMIC_ALC_ON = 258;
const OPrimitiveRequest oprmreqMIC_ALC_OFF = 259;

// ---- camera

const OPrimitiveRequest oprmreqCAM_SET_WHITE_BALANCE = 384;  // parameter: CameraParam
const OPrimitiveRequest oprmreqCAM_SET_GAIN = 385;           // parameter: CameraParam
const OPrimitiveRequest oprmreqCAM_SET_SHUTTER_SPEED = 386;  // parameter: CameraParam
const OPrimitiveRequest oprmreqCAM_GET_CDT_TABLE = 387;      // parameter and result: Cdt
const OPrimitiveRequest oprmreqCAM_AE_ON = 388;              // automatic exposure
const OPrimitiveRequest oprmreqCAM_AE_OFF = 389;
const OPrimitiveRequest oprmreqCAM_AWB_ON = 390;  // automatic white balance
const OPrimitiveRequest oprmreqCAM_AWB_OFF = 391;

const longword ocamparamUNDEF = 0;
const longword ocamparamWB_INDOOR_MODE = 1;   // for light of 2800 K
const longword ocamparamWB_OUTDOOR_MODE = 2;  // for light of 7000 K
const longword ocamparamWB_FL_MODE = 3;       // for fluorescent light of 4300 K: the default
const longword ocamparamGAIN_LOW = 1;         // 0 dB
const longword ocamparamGAIN_MID = 2;         // 0 dB
const longword ocamparamGAIN_HIGH = 3;        // 6 dB
const longword ocamparamSHUTTER_SLOW = 1;     // 1/50 s
const longword ocamparamSHUTTER_MID = 2;      // 1/100 s: the default
const longword ocamparamSHUTTER_FAST = 3;     // 1/200 s

struct OPrimitiveControl_CameraParam {
  longword camparam;
  OPrimitiveControl_CameraParam(longword p) : camparam(p) {}
};

struct OPrimitiveControl_Cdt {
  longword index;
  byte table[100];

  OPrimitiveControl_Cdt() { Clear(0); }
  OPrimitiveControl_Cdt(longword number) { Clear(number); }

 private:
  void Clear(longword number) {
    index = number;
    for (size_t i = 0; i < sizeof table; i++) table[i] = 0;
  }
};

// ---- Bluetooth

const OPrimitiveRequest oprmreqBT_ATTACH = 512;
const OPrimitiveRequest oprmreqBT_DETACH = 513;
const OPrimitiveRequest oprmreqSENSOR_WATCH_BT_SWITCH = 896;  // parameter: BtSwitchWatcherInfo

typedef longword OBtSwitchEvent;
const OBtSwitchEvent obtswitcheventUNDEF = 0;
const OBtSwitchEvent obtswitcheventVALUE_CHANGED = 1;

// Requests that an OPrimitiveControl_BtSwitchEvent is sent to `entry` whenever `event` of a
// Bluetooth switch happens.
struct OPrimitiveControl_BtSwitchWatcherInfo {
  OBtSwitchEvent event;
  OServiceEntry entry;
};

struct OPrimitiveControl_BtSwitchEvent {
  OBtSwitchEvent event;
  longword value;
};

// ---- requests by which a program commands a primitive, or reads its value, without a vector

const OPrimitiveRequest oprmreqJOINT2_SET_COMMAND = 640;   // parameter: JointCommandValue2
const OPrimitiveRequest oprmreqJOINT2_GET_VALUE = 641;     // result: JointValue
const OPrimitiveRequest oprmreqLED2_SET_COMMAND = 768;     // parameter: LEDCommandValue2
const OPrimitiveRequest oprmreqLED3_SET_COMMAND = 1024;    // parameter: LEDCommandValue3
const OPrimitiveRequest oprmreqJOINT4_SET_COMMAND = 1152;  // parameter: JointCommandValue4

// The structs for the parameters and results of the requests above.  Each struct contains the
// command or the value for one frame, in the same form as in a vector.
struct OPrimitiveControl_JointCommandValue2 {
  OJointCommandValue2 command;
  OPrimitiveControl_JointCommandValue2(slongword value) {
    command.value = value;
    command.padding = 0;
  }
};

struct OPrimitiveControl_JointValue {
  OJointValue jval;
  OPrimitiveControl_JointValue() {}  // initialises no field
  OPrimitiveControl_JointValue(slongword val, word sig, sword pwm, slongword refVal, word refSig)
      : jval(val, sig, pwm, refVal, refSig) {}
};

struct OPrimitiveControl_LEDCommandValue2 {
  OLEDCommandValue2 command;
  OPrimitiveControl_LEDCommandValue2(OLEDValue led) {
    command.led = led;
    command.period = 0;
    command.reserved = 0;
  }
};

struct OPrimitiveControl_LEDCommandValue3 {
  OLEDCommandValue3 command;
  OPrimitiveControl_LEDCommandValue3(sword intensity, OLED3Mode mode) {
    command.intensity = intensity;
    command.mode = mode;
    command.period = 0;
    command.reserved = 0;
  }
};

struct OPrimitiveControl_JointCommandValue4 {
  OJointCommandValue4 command;
  OPrimitiveControl_JointCommandValue4(OJointValue4 value) {
    command.value = value;
    command.period = 1;
    command.reserved = 0;
  }
};

// Requests of OPENR::ControlPrimitive() from this number on are defined by the makers of devices.
const OPrimitiveRequest oprmreqPRIVATE_BASE = 1048576;

#endif  // OPENR_OPRIMITIVECONTROL_H_INCLUDED
