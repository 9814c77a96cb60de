//
// What the objects send each other.
//
// Plain data of fixed width without padding bytes, so that every byte of a message has a
// meaning (a recorded run is compared byte by byte).  A sender begins with a message of
// zeros: SomeMessage message = {}; or memset().
//
// Angles are urad; speeds 0.01 degree/s; accelerations 0.01 degree/s^2.  Joints, LEDs and
// plungers are named by their index in RobotConstants.
//

#ifndef Messages_h_DEFINED
#define Messages_h_DEFINED

#include "FixedTypes.h"
#include "MtnName.h"
#include "RobotDescription.h"

enum MoverCommandKind {
    moverkindPOSITION = 1,      // joint, value
    moverkindSPEED = 2,         // joint, value
    moverkindACCELERATION = 3,  // joint, value
    moverkindPLAY = 4,          // file, loops, keyFramesPerVector
    moverkindSTOP = 5           // ends a motion where it is
};

// RCServer.Mover, Controller.Mover -> JointMover.Mover
struct MoverCommand {
    Sint32 kind;  // MoverCommandKind
    Sint32 joint;
    Sint32 value;
    Sint32 loops;               // >= 1
    Sint32 keyFramesPerVector;  // 0: as JointMover likes
    char file[MTN_NAME_SIZE];   // "WALK.MTN"
};
COMPILE_TIME_CHECK(MoverCommandHasNoPadding, sizeof(MoverCommand) == 5 * 4 + MTN_NAME_SIZE);

enum BatchJointFlags {
    batchPOSITION_GIVEN = 1,  // until then the joint is left where it is
    batchMOTOR_OFF = 2        // gain off, the joint can be moved by hand
};

struct BatchJoint {
    Sint32 position;
    Sint32 speed;
    Sint32 acceleration;
    Sint32 flags;  // BatchJointFlags
};

// Controller.BatchMover -> JointMover.BatchMover: the whole buffer, sent when something in
// it has changed.  JointMover acts on what differs from the buffer before (Hohl 2004,
// 5.3.6); to begin with, that is start-up speed, default acceleration and no flags.
struct BatchMoverCommand {
    BatchJoint joint[MAX_JOINTS];
};
COMPILE_TIME_CHECK(BatchMoverCommandHasNoPadding, sizeof(BatchMoverCommand) == MAX_JOINTS * 16);

// JointMover.SetValue -> RCServer.SetValue, Controller.SetValue: at every vector of a
// motion, and at every change of state.  One event may carry several; the last is newest.
// JointMover moves no plungers: Controller, which has the ears, follows a motion by these.
struct SetValueMessage {
    Sint32 state;              // MoverState
    Sint32 keyFrame;           // reached when the positions were measured; -1: none, or over
    Uint8 isOver;              // 1: `file` is over, played or not
    Uint8 earMask;             // plungers that the motion moves: bit i stands for plunger i
    Uint8 earOn;               // those of them that are on in `keyFrame`
    Uint8 reserved;            // 0
    char file[MTN_NAME_SIZE];  // the motion concerned; empty: none
    Sint32 commanded[MAX_JOINTS];
    Sint32 measured[MAX_JOINTS];
};
COMPILE_TIME_CHECK(SetValueMessageHasNoPadding,
                   sizeof(SetValueMessage) == 12 + MTN_NAME_SIZE + 2 * MAX_JOINTS * 4);

// RCServer.LedEar -> Controller.LedEar.  Bit i stands for LED or plunger i.
struct LedEarState {
    Uint32 ledMask;  // which LEDs were commanded
    Uint32 ledOn;
    Uint32 earMask;
    Uint32 earOn;
};
COMPILE_TIME_CHECK(LedEarStateHasNoPadding, sizeof(LedEarState) == 16);
COMPILE_TIME_CHECK(LedsFitTheirMask, MAX_LEDS <= 32 && MAX_PLUNGERS <= 8);

// JointMover.MainExecution -> Controller.MainExecution: once, when the robot stands.
struct MainExecutionMessage {
    Sint32 state;  // MoverState
};

#endif  // Messages_h_DEFINED
