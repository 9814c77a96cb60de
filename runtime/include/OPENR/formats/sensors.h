// Sensor vectors: the values of every sensor and joint of the robot, four frames of 8 ms at a time.
//
// The order of the elements is fixed for each model of robot; a vector of the ERS-210 has 31
// elements (Model Information ERS-210, 2).
#ifndef OPENR_FORMATS_SENSORS_H_INCLUDED
#define OPENR_FORMATS_SENSORS_H_INCLUDED

#include <OPENR/formats/vector_info.h>

const size_t osensorframeMAX_FRAMES = 16;

// Special values in sensor data, which mean that no value was measured.
const word osensorframeINVALID_SIGNAL = 0xffff;
const slongword opsdINVALID_VALUE = 0;

// Describes the sensor values of one primitive; 32 bytes.
struct OSensorFrameInfo {
  ODataType type;            // selects the struct of the frames, such as OJointValue
  OPrimitiveID primitiveID;  // set even if the primitive was not opened
  longword frameNumber;      // number of the first frame
  longword numFrames;        // number of frames in use; 4 on the robot
  longword frameSize;        // size of a frame in bytes, 16
  longword dataOffset;       // offset in bytes from the start of the vector to the OSensorFrameData
  longword dataSize;         // size in bytes, 256
  longword padding[1];

  void Set(ODataType dataType, OPrimitiveID id, size_t nframes) {
    type = dataType;
    primitiveID = id;
    numFrames = static_cast<longword>(nframes);
  }
};

// The general form of the sensor value of one frame, 16 bytes.
struct OSensorValue {
  slongword value;
  word signal;  // raw reading of the sensor
  word padding[5];
};

// The sensor values of one primitive, oldest frame first, 256 bytes.  Programs cast a frame to the
// struct that belongs to OSensorFrameInfo::type.
struct OSensorFrameData {
  OSensorValue frame[osensorframeMAX_FRAMES];
};

struct OSensorFrameVectorData {
  ODataVectorInfo vectorInfo;
  OSensorFrameInfo info[1];  // in memory the array has vectorInfo.maxNumData elements

  void SetNumData(size_t n) { vectorInfo.numData = static_cast<longword>(n); }
  OSensorFrameInfo* GetInfo(int index) { return info + index; }
  OSensorFrameData* GetData(int index) {
    char* const start = reinterpret_cast<char*>(this);
    return reinterpret_cast<OSensorFrameData*>(start + GetInfo(index)->dataOffset);
  }
};

// ---- structs with the sensor value of one frame, 16 bytes each

struct OAcceleration {
  slongword value;  // in 10^-6 m/s^2
  word signal;
  word padding[5];
};

struct OAngularVelocity {
  slongword value;  // in 10^-6 rad/s
  word signal;
  word padding[5];
};

struct OTemperature {
  slongword value;  // in 10^-6 degree Celsius
  word signal;
  word padding[5];
};

struct OForce {
  slongword value;  // in 10^-6 N
  word signal;
  word padding[5];
};

struct OPressure {
  slongword value;  // in 10^-6 Pa
  word signal;
  word padding[5];
};

struct OLength {
  slongword value;  // in 10^-6 m
  word signal;
  word padding[5];
};

typedef longword OSwitchValue;
const OSwitchValue oswitchOFF = 0;
const OSwitchValue oswitchON = 1;

struct OSwitchStatus {
  OSwitchValue value;
  word signal;
  word padding[5];
};

struct OJointValue {
  slongword value;     // measured angle, 10^-6 rad
  word signal;         // raw reading of the potentiometer, 10 bits
  sword pwmDuty;       // requested motor drive; may exceed +-255, the motor's limit
  slongword refValue;  // set point at the time of the sample, 10^-6 rad
  word refSignal;      // the set point, in the unit of `signal`
  word padding[1];

  OJointValue() {}  // initialises no field
  OJointValue(slongword val, word sig, sword pwm, slongword refVal, word refSig)
      : value(val), signal(sig), pwmDuty(pwm), refValue(refVal), refSignal(refSig) {
    padding[0] = 0;
  }
};

#endif  // OPENR_FORMATS_SENSORS_H_INCLUDED
