//
// The messages between the objects.
//
// Messages are plain data of fixed width.  Recorded runs are compared byte by byte, so no byte of a
// message may be uninitialized.  For this reason messages have no padding bytes, and a sender first
// sets all bytes of a message to zero: SomeMessage message = {}; or memset().
//
// Angles are in urad (10^-6 rad), speeds in 0.01 degree/s, accelerations in 0.01 degree/s^2.
// Joints, LEDs and ears (plungers) are identified by their index in RobotConstants.
//

#ifndef Messages_h_DEFINED
#define Messages_h_DEFINED

#include "FixedTypes.h"
#include "MtnName.h"
#include "RobotDescription.h"

enum MoverCommandKind {
    moverkindPOSITION = 1,      // uses the fields `joint` and `value`
    moverkindSPEED = 2,         // uses the fields `joint` and `value`
    moverkindACCELERATION = 3,  // uses the fields `joint` and `value`
    moverkindPLAY = 4,          // uses the fields `file`, `loops` and `keyFramesPerVector`
    moverkindSTOP = 5,          // ends the motion that plays
    moverkindMOTOR_OFF = 6,     // uses the field `joint`; MOVER_ALL_JOINTS: power of all motors
    moverkindMOTOR_ON = 7,      // uses the field `joint`; MOVER_ALL_JOINTS: power of all motors
    moverkindGAINS = 8,         // uses the fields `joint` and `gain`
    moverkindTRACK = 9          // uses the fields `joint`, `value` and `frames`
};

// Value of MoverCommand::joint that stands for all joints.
const Sint32 MOVER_ALL_JOINTS = -1;

// The command that RCServer.Mover and Controller.Mover send to JointMover.Mover.
struct MoverCommand {
    Sint32 kind;  // a value of MoverCommandKind
    Sint32 joint;
    Sint32 value;
    union {
        Sint32 loops;   // how often the motion is played, >= 1
        Sint32 frames;  // time for the movement to `value`, in frames of 8 ms, >= 1
    };
    Sint32 keyFramesPerVector;  // number of key frames in a vector; 0 lets JointMover choose
    char file[MTN_NAME_SIZE];   // name of the motion file, such as "WALK.MTN"
    Sint32 gain[3];             // P, I and D gain
};
COMPILE_TIME_CHECK(MoverCommandHasNoPadding, sizeof(MoverCommand) == 8 * 4 + MTN_NAME_SIZE);

enum BatchJointFlags {
    batchPOSITION_GIVEN = 1,  // `position` is valid; otherwise the joint stays where it is
    batchMOTOR_OFF = 2        // the gain is off, so that the joint can be moved by hand
};

struct BatchJoint {
    Sint32 position;
    Sint32 speed;
    Sint32 acceleration;
    Sint32 flags;  // bits of BatchJointFlags
};

// The message of Controller.BatchMover to JointMover.BatchMover: the whole buffer of joint
// commands, sent when a value in it has changed.  JointMover acts on the differences from the
// buffer that came before (Hohl 2004, 5.3.6).  The first buffer is compared with the values at
// start-up: highest speeds, default accelerations and no flags.
struct BatchMoverCommand {
    BatchJoint joint[MAX_JOINTS];
};
COMPILE_TIME_CHECK(BatchMoverCommandHasNoPadding, sizeof(BatchMoverCommand) == MAX_JOINTS * 16);

// The message of JointMover.SetValue to RCServer.SetValue and Controller.SetValue.  It is sent at
// the end of every vector of a motion, at every change of state or of motor power, and when a
// motion is refused.  One event may carry several messages; the last is the newest.  JointMover
// does not move the ears, because Controller commands them: Controller sets them as the message
// says.
struct SetValueMessage {
    Sint32 state;              // a value of MoverState
    Sint32 keyFrame;           // key frame that the motion has reached last; -1 if no motion plays
    Uint8 isOver;              // 1 if the motion of `file` has ended or was refused
    Uint8 earMask;             // ears (plungers) that the motion moves: bit i stands for ear i
    Uint8 earOn;               // bits of earMask whose ears are on in key frame `keyFrame`
    Uint8 motorsOff;           // 1 if a command has switched motor power off
    char file[MTN_NAME_SIZE];  // file of the motion; "" if there is no motion
    Sint32 commanded[MAX_JOINTS];
    Sint32 measured[MAX_JOINTS];
};
COMPILE_TIME_CHECK(SetValueMessageHasNoPadding,
                   sizeof(SetValueMessage) == 12 + MTN_NAME_SIZE + 2 * MAX_JOINTS * 4);

// The message of RCServer.LedEar to Controller.LedEar.  Bit i stands for LED or ear i.
struct LedEarState {
    Uint32 ledMask;  // LEDs that were commanded; the other LEDs stay as they are
    Uint32 ledOn;
    Uint32 earMask;
    Uint32 earOn;
};
COMPILE_TIME_CHECK(LedEarStateHasNoPadding, sizeof(LedEarState) == 16);
COMPILE_TIME_CHECK(LedsFitTheirMask, MAX_LEDS <= 32 && MAX_PLUNGERS <= 8);

// The message of JointMover.MainExecution to Controller.MainExecution.  It is sent once to each
// Controller, when the robot stands.
struct MainExecutionMessage {
    Sint32 state;  // a value of MoverState
};

#endif  // Messages_h_DEFINED
