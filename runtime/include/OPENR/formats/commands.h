// Command vectors: set points for joints, states for LEDs and ears.
//
// A frame is 8 ms.  A vector changes only the primitives that it lists.  If no other vector
// follows, joints keep their last set point (Level 2 Reference Guide, 4.2).
#ifndef OPENR_FORMATS_COMMANDS_H_INCLUDED
#define OPENR_FORMATS_COMMANDS_H_INCLUDED

#include <OPENR/formats/vector_info.h>

const size_t ocommandMAX_FRAMES = 16;

// Describes the commands for one primitive; 32 bytes.
struct OCommandInfo {
  ODataType type;            // selects the struct of the commands, such as OJointCommandValue2
  OPrimitiveID primitiveID;  // from OPENR::OpenPrimitive()
  longword frameNumber;      // the frame in which output began; set by the system
  longword numFrames;        // number of frames in use, at most ocommandMAX_FRAMES
  longword frameSize;        // size of a frame in bytes, 8
  longword dataOffset;       // offset in bytes from the start of the vector to the OCommandData
  longword dataSize;         // size in bytes, 128
  longword padding[1];

  void Set(ODataType dataType, OPrimitiveID id, size_t nframes) {
    type = dataType;
    primitiveID = id;
    numFrames = static_cast<longword>(nframes);
  }
};

// The general form of the command structs below, which all have 8 bytes.
struct OCommandValue {
  slongword value[2];
};

// The commands for one primitive, 128 bytes.  Programs cast `value` to a pointer to the struct that
// belongs to OCommandInfo::type.
struct OCommandData {
  OCommandValue value[ocommandMAX_FRAMES];
};

struct OCommandVectorData {
  ODataVectorInfo vectorInfo;
  OCommandInfo info[1];  // in memory the array has vectorInfo.maxNumData elements

  void SetNumData(size_t n) { vectorInfo.numData = static_cast<longword>(n); }
  OCommandInfo* GetInfo(int index) { return info + index; }
  OCommandData* GetData(int index) {
    char* const start = reinterpret_cast<char*>(this);
    return reinterpret_cast<OCommandData*>(start + GetInfo(index)->dataOffset);
  }
};

// ---- values in commands for ears (odataJOINT_COMMAND3 and 4) and for LEDs

typedef longword OJointValue3;
const OJointValue3 ojoint3_STATE0 = 0;
const OJointValue3 ojoint3_STATE1 = 1;
const OJointValue3 ojoint3_STATE_UNDEF = 0xffffffff;

typedef longword OJointValue4;
const OJointValue4 ojoint4_STATE0 = 0;
const OJointValue4 ojoint4_STATE1 = 1;
const OJointValue4 ojoint4_STATE_UNDEF = 0xffffffff;

typedef longword OLEDValue;
const OLEDValue oledOFF = 0;
const OLEDValue oledON = 1;

typedef word OLED3Mode;
const OLED3Mode oled3_MODE_A = 0;
const OLED3Mode oled3_MODE_B = 1;
const OLED3Mode oled3_MODE_UNDEF = 0xffff;

// ---- command structs, 8 bytes each; programs cannot keep a value in the field `reserved`, because
// the system may change the field while it plays the vector

// A command of the type odataJOINT_COMMAND2: the set point of a joint for one frame.
struct OJointCommandValue2 {
  slongword value;  // in 10^-6 rad
  slongword padding;
};

// A command of the type odataJOINT_COMMAND3, for the ears of the ERS-210.
struct OJointCommandValue3 {
  OJointValue3 value;
  word reserved;
  word padding;
};

// A command of the type odataJOINT_COMMAND4, for the ears of the ERS-7.
struct OJointCommandValue4 {
  OJointValue4 value;
  word period;  // duration in frames of 8 ms
  word reserved;
};

// A command of the type odataLED_COMMAND2: switches an LED on or off.
struct OLEDCommandValue2 {
  OLEDValue led;
  word period;  // duration in frames of 8 ms
  word reserved;
};

// A command of the type odataLED_COMMAND3, for the LEDs in the face and back of the ERS-7.
struct OLEDCommandValue3 {
  sword intensity;  // 0..255
  OLED3Mode mode;
  word period;  // duration in frames of 8 ms
  word reserved;
};

// ---- command structs for older robots

// A command of the type odataJOINT_COMMAND: the set point and the gains of a joint.
struct OJointCommandValue {
  slongword value;  // in 10^-6 rad
  byte p;
  byte i;
  byte d;
  byte padding;

  void Set(slongword val, byte kp, byte ki, byte kd) {
    value = val;
    p = kp;
    i = ki;
    d = kd;
  }
};

// A command of the type odataLED_COMMAND, for the LEDs of older robots.
struct OLEDCommandValue {
  OLEDValue led;
  word period;  // duration in units of 16 frames (128 ms)
  word padding;
};

// The requests that a command of the type odataCAMERA_COMMAND can make of the camera.
typedef word OCameraRequest;
const OCameraRequest ocamreqAE_OFF = 0;
const OCameraRequest ocamreqAE_ON = 1;
const OCameraRequest ocamreqSET_AWB_MODE = 2;
const OCameraRequest ocamreqDRAW_BOX = 3;

struct OCameraCommandValue {
  OCameraRequest request;
  byte param[6];
};
const byte ocamparamAWB_AUTO_MODE = 0;
const byte ocamparamAWB_INDOOR_MODE = 1;
const byte ocamparamAWB_OUTDOOR_MODE = 2;
const byte ocamparamAWB_USER_MODE = 3;
const byte ocamparamAWB_FL_MODE = 4;
const byte ocamparamBOX1 = 1;
const byte ocamparamBOX2 = 2;

// A command of the type odataRAW_JOINT_COMMAND: a raw value (`signal`) for a joint, and the gains
// of the joint.
struct ORawJointCommandValue {
  word signal;
  byte p;
  byte i;
  byte d;
  byte padding[3];

  void Set(word sig, byte kp, byte ki, byte kd) {
    signal = sig;
    p = kp;
    i = ki;
    d = kd;
  }
};

// A command of the type odataRAW_JOINT_COMMAND2: a raw value (`signal`) for a joint.
struct ORawJointCommandValue2 {
  word signal;
  word padding[3];
};

// A command of the type odataRAW_CAMERA_COMMAND: a raw value (`signal`) for the camera.
struct ORawCameraCommandValue {
  word signal;
  word padding[3];

  void Set(word sig) { signal = sig; }
};

// A command of the type odataRAW_LED_COMMAND: a raw value (`signal`) for an LED.
struct ORawLEDCommandValue {
  word signal;
  word padding[3];

  void Set(word sig) { signal = sig; }
};

#endif  // OPENR_FORMATS_COMMANDS_H_INCLUDED
