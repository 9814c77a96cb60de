//
// Packets of streams of the remote control.  The robot sends them without further requests to
// clients that have subscribed (version 2, docs/remote-control.md).
//

#ifndef RemoteStreams_h_DEFINED
#define RemoteStreams_h_DEFINED

#include <string>
#include <vector>

#include "FixedTypes.h"
#include "RemotePacket.h"

enum RcStream {
    rcstreamSENSORS = 0,     // values of RcSensors
    rcstreamSET_VALUES = 1,  // reports of JointMover: RcSetValues
    NUM_RC_STREAMS
};

// Number of frames in a sensor vector; periods of streams are multiples of this number.
const int RC_FRAMES_PER_VECTOR = 4;

struct RcSubscribe {
    Uint8 stream;   // a value of RcStream
    Uint16 period;  // smallest number of frames between two packets

    void Write(RcWriter* out) const;
    bool Read(RcReader* in);
};

// The first fields of an EVENT packet, by which a robot sends a client the values of a stream
// (RcStream) that the client has subscribed to.  The values follow these fields.
struct RcEventHead {
    Uint8 stream;    // a value of RcStream
    Uint16 leftOut;  // number of values that the client has missed since the packet before

    void Write(RcWriter* out) const;
    void Read(RcReader* in);  // reads the fields above, but not the values of the stream
};

// A report of JointMover: its state and, while a motion plays, the key frame.  Positions are in
// 0.01 degree.
struct RcSetValues {
    Uint8 state;       // a value of MoverState
    Uint8 isOver;      // 1 if the motion of `file` has ended or was refused
    Uint8 motorsOff;   // 1 if a command MOTOR_OFF has switched motor power off
    Uint8 earMask;     // ears that the motion moves: bit i stands for ear i
    Uint8 earOn;       // bits of earMask whose ears are on
    Sint32 keyFrame;  // key frame to which the positions belong; -1 if no motion plays
    std::string file;  // file of the motion; "" if no motion plays
    std::vector<Sint32> commanded;
    std::vector<Sint32> measured;  // measured positions, as many as in `commanded`

    void Write(RcWriter* out) const;
    bool Read(RcReader* in);
};

#endif  // RemoteStreams_h_DEFINED
