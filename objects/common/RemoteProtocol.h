//
// Requests and answers of the remote control (docs/remote-control.md).
//
// Positions are in 0.01 degree, speeds in 0.01 degree/s, accelerations in 0.01 degree/s^2.  Each
// struct has functions to write and to read it, which server and client share.  Read() returns
// false when bytes are missing or left over.
//

#ifndef RemoteProtocol_h_DEFINED
#define RemoteProtocol_h_DEFINED

#include <string>
#include <vector>

#include "FixedTypes.h"
#include "RemotePacket.h"

enum RcCommand {
    rcINFO = 0x01,
    rcDESCRIBE = 0x02,
    rcGET = 0x10,
    rcMOVE = 0x11,
    rcSPEED = 0x12,
    rcACCEL = 0x13,
    rcLED = 0x20,
    rcEAR = 0x21,
    rcSENSORS = 0x30,
    rcMTN_PLAY = 0x40,
    rcMTN_STOP = 0x41,
    // The commands below need version 2 of the remote control's protocol.
    rcBATCH = 0x03,
    rcGAINS = 0x14,
    rcMOTOR_OFF = 0x15,
    rcMOTOR_ON = 0x16,
    rcTRACK = 0x17,
    rcPOWER = 0x31,
    rcSUBSCRIBE = 0x32,  // RemoteStreams.h has the formats of streams
    rcUNSUBSCRIBE = 0x33,
    rcCAMERA = 0x34,  // RemoteCamera.h has the formats of pictures
    rcCAMERA_PART = 0x35,
    // The command of two kinds of packets: the robot sends the values of a stream in EVENT packets,
    // and a client acknowledges these packets by EVENT packets.  No EVENT packet has an answer.
    rcEVENT = 0x3f,
    rcMTN_LIST = 0x42,  // the commands for files are in RemoteFiles.h
    rcUPLOAD_BEGIN = 0x50,
    rcUPLOAD_DATA = 0x51,
    rcUPLOAD_END = 0x52,
    rcDELETE = 0x53,
    rcDOWNLOAD = 0x54,
    rcLOG = 0x60,  // RemoteLog.h has the format of the log
    rcREBOOT = 0x70,
    rcSHUTDOWN = 0x71,
    // Sends the token that the server of `openr run --listen` asks for.  The robot itself does not
    // know this command.
    rcTOKEN = 0x72
};

enum RcStatus {
    rcOK = 0,
    rcerrorBAD_PACKET = 1,  // the bytes are no packet; the server closes the connection
    rcerrorVERSION = 2,     // the server does not know this protocol version
    rcerrorUNKNOWN_COMMAND = 3,
    rcerrorNOT_IMPLEMENTED = 4,  // the command is reserved
    rcerrorMALFORMED = 5,        // the payload is too short or too long
    rcerrorNO_SUCH_DEVICE = 6,   // the index is out of range
    rcerrorBUSY = 7,             // the robot cannot do this now
    rcerrorNO_SUCH_FILE = 8,
    rcerrorBAD_FILE = 9,  // the file is broken, is no motion or image, or is not for this robot
    rcerrorBAD_VALUE = 10,
    rcerrorNOT_WRITTEN = 11,  // the stick is full or cannot be written
    // Data came for an upload that was not begun, or has ended with an error.
    rcerrorNO_UPLOAD = 12,
    rcerrorNOT_IN_BATCH = 13,  // the command must be sent in a packet of its own
    rcerrorTOO_LONG = 14,      // the answer has no room in the batch
    rcerrorNO_PICTURE = 15,    // the request is about a picture for which this client has not asked
    rcerrorNOT_ALLOWED = 16    // the token is missing or wrong, or the server forbids the request
};

// Size of the smallest answer to a request in a batch, in bytes.  This size has room for a payload
// of 24 bytes, or for an error with at least 23 characters of its text.
const int RC_SMALLEST_BATCH_ANSWER = RC_ANSWER_HEADER_SIZE + 24;

// Largest number of requests in a batch.  With this limit, the smallest answers to all requests fit
// into the answer to the batch.
const int RC_MAX_BATCH = (RC_MAX_PACKET - RC_ANSWER_HEADER_SIZE) / RC_SMALLEST_BATCH_ANSWER;

// The header with which an answer of the remote control begins.
struct RcAnswerHeader {
    RcHeader header;
    Uint32 frame;  // frame number of the newest sensor values; 0xffffffff before the first values
    Uint16 status;  // a value of RcStatus

    // Reads the header from a packet.  Returns false when the packet is too short for an answer.
    bool Read(const RcFramer& packet);
};

struct RcInfo {
    Uint8 numJoints, numLeds, numEars, numBinary, numOther, numMisc;
    Uint8 state;           // a value of MoverState
    std::string design;    // such as "ERS-210"
    std::string software;  // "openr-host RCServer"

    // The values `processor`, `largestMotion` and `largestImage` are sent in version 2 of the
    // protocol only.
    bool hasFiles;         // whether the packet has the three values below
    Uint8 processor;       // an ImageProcessor: the CPU for which the robot's images are built
    Uint32 largestMotion;  // size in bytes of the largest motion that can be uploaded
    Uint32 largestImage;   // size in bytes of the largest image that can be uploaded

    void Write(RcWriter* out) const;
    bool Read(RcReader* in);
};

enum RcDeviceKind {
    rcdeviceJOINT,
    rcdeviceLED,
    rcdeviceEAR,
    rcdeviceBINARY,
    rcdeviceOTHER,
    NUM_RC_DEVICES
};

// Indices of the values of a joint in RcDescription: limits of position, speed and acceleration,
// and the default acceleration.
enum RcJointValue {
    rcjointMIN,
    rcjointMAX,
    rcjointMIN_SPEED,
    rcjointMAX_SPEED,
    rcjointMIN_ACCEL,
    rcjointMAX_ACCEL,
    rcjointDEFAULT_ACCEL,
    NUM_RC_JOINT_VALUES
};

struct RcDescription {
    std::string name;   // short name, such as "LF_j1"
    std::string title;  // "Left fore leg J1"
    std::string locator;
    // For a joint, its numbers in the order of RcJointValue; for a sensor, its SensorKind; for all
    // other devices, no value.
    std::vector<Sint32> values;

    void Write(RcWriter* out) const;
    bool Read(RcReader* in);
};

struct RcJointState {
    Sint32 position;      // measured position
    Sint32 speed;         // limit of speed that the remote control has set last
    Sint32 acceleration;  // limit of acceleration that the remote control has set last

    void Write(RcWriter* out) const;
    bool Read(RcReader* in);
};

// Number that MOTOR_OFF and MOTOR_ON may have in place of the index of a joint: it stands for all
// joints and for motor power.
const Uint8 RC_ALL_JOINTS = 255;

// Largest P, I or D gain.  The limit is the largest number of 7 bits, because a report says that
// gains have at most 7 bits.  People used P gains up to 63 (docs/openr/field-notes.md 7.14, 7.15).
const int RC_MAX_GAIN = 127;

// Gains of the servo of a joint.  A gain g with shift s acts like g x 2^(s-16).
struct RcGains {
    Uint8 isOn;      // 1 if the gain is enabled, 0 if the joint is limp
    Uint16 gain[3];  // P, I and D gain
    Uint16 shift[3];

    void Write(RcWriter* out) const;
    bool Read(RcReader* in);
};

// Power and battery of the robot, from OPENR::GetPowerStatus().
struct RcPower {
    Uint32 robotStatus;    // bits orsb... of the SDK
    Uint16 batteryStatus;  // bits obsb... of the SDK
    Uint16 capacity;       // remaining capacity in %
    Uint16 fullCapacity;   // in mAh
    Uint16 voltage;        // in mV
    Sint32 current;        // in mA
    Sint32 temperature;    // in 0.01 degree Celsius

    void Write(RcWriter* out) const;
    bool Read(RcReader* in);
};

// The sensor values in an answer to the client, grouped and ordered as in Hohl 2004, table 3.8.
struct RcSensors {
    Uint8 state;                   // a value of MoverState
    std::vector<Sint32> joints;    // measured positions, in 0.01 degree
    std::vector<Sint32> binary;    // values of binary sensors, 0 or 1
    std::vector<Sint32> other;     // in 10^-6 N, m, degree C or m/s^2, or in A/D counts
    std::vector<Sint32> misc;      // battery: capacity in %, temperature in 0.01 degree C
    std::vector<Sint32> keyFrame;  // a single number: the key frame reached last (0 to 32767), or
                                   // -1

    void Write(RcWriter* out) const;
    bool Read(RcReader* in);
};

struct RcPlayRequest {
    std::string file;          // such as "WALK.MTN"
    Uint16 loops;              // how often the motion is played, >= 1
    Uint8 keyFramesPerVector;  // number of key frames in a command vector; 0 lets the robot choose

    void Write(RcWriter* out) const;
    bool Read(RcReader* in);
};

struct RcPlayAnswer {
    Uint32 durationMs;  // length of one loop
    Uint16 keyFrames;
    Uint16 loops;

    void Write(RcWriter* out) const;
    bool Read(RcReader* in);
};

#endif  // RemoteProtocol_h_DEFINED
