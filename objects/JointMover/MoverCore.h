//
// JointMover without OPEN-R: the state machine of Hohl 2004, section 4.1.1, and the making
// of command vectors.
//
//   filling -> gains -> broadbase -> sleeping -> crouching -> standing -> accepting-commands
//   accepting-commands -> [prepare-mtn ->] mtn -> accepting-commands
//
// The object asks for a vector whenever it has a free region and the effector is ready, and tells
// when a vector has ended.  When no joint moves there is no vector: the robot keeps its set points,
// and a robot that stands still costs no messages.
//

#ifndef MoverCore_h_DEFINED
#define MoverCore_h_DEFINED

#include <stddef.h>

#include <string>

#include "JointSet.h"
#include "MoverPort.h"
#include "MtnFile.h"
#include "MtnPlayer.h"

// Frames of a vector outside of motions: 4 x 8 ms, which is the period of the sensor vectors.  Two
// vectors are in the effector, so a command begins to act after 64 ms at most.  With full vectors
// of 128 ms it would be 256 ms; shorter vectors would double the messages for little gain.
const int MANUAL_VECTOR_FRAMES = 4;

// Vectors that are in the effector at any time: one plays and one waits.
const int MAX_VECTORS_UNDER_WAY = 2;

// A motion begins without a movement to its first key frame when all joints are nearer to it than
// this (Hohl 2004, section 4.1.2: smaller than 45 degrees).
const Sint32 PREPARE_LIMIT_URAD = 785398;

// The positions of the next command vector, for every joint of the robot, in urad.
struct VectorPlan {
    int numFrames;  // 1 to MAX_VECTOR_FRAMES
    Sint32 urad[MAX_VECTOR_FRAMES][MAX_JOINTS];
};

class MoverCore {
public:
    // `port` must outlive the core.
    explicit MoverCore(MoverPort* port);

    // Begins the start-up of the robot; measures all joints.
    void Begin(const RobotConstants* robot);

    MoverState State() const { return state_; }
    bool AcceptsMotion() const { return state_ == moverACCEPTING_COMMANDS; }

    // Makes the next vector.  Returns false when there is nothing to send, or when
    // MAX_VECTORS_UNDER_WAY have not ended yet.
    bool NextVector(VectorPlan* plan);

    // Tells that the oldest vector has ended.
    void VectorEnded();

    // Sets position, speed or acceleration of one joint.  Has no effect before the robot stands,
    // and on joints that are switched off.  A joint that a motion moves goes to the position after
    // the motion.
    void MoveJoint(const MoverCommand& command);

    // Carries out the differences between this buffer of a controller and the one before.  Besides
    // what MoveJoint() can do, a buffer switches joints off and on again.
    void Batch(const BatchMoverCommand& command);

    // Begins a motion from the bytes of a file.  Returns false with a reason when they are no
    // motion for this robot, or when the robot is not accepting commands.
    bool Play(const MoverCommand& command, const Uint8* bytes, size_t size, std::string* error);

    // Ends a motion, or the movement to its first key frame, at once.
    void Stop();

    // Reports on SetValue that the motion of `command` is over.  Changes nothing else.
    void ReportRefusal(const MoverCommand& command);

private:
    struct UnderWay {
        Sint32 number;
        Sint32 stateCount;  // stateCount_ when the vector was made
        Sint32 keyFrame;
        bool arrived;                  // whether the state has done its work at the vector's end
        Sint32 commanded[MAX_JOINTS];  // positions at the vector's end
    };

    void Enter(MoverState state);
    void Advance();
    void EnterPosture(int index);
    bool SetPostureGoals(int index);
    void BeginMotion();
    void EndMotion();
    bool NeedsPreparation() const;
    bool HasArrived() const;
    void MakeFrame(Sint32 urad[MAX_JOINTS]);
    void Remember(const VectorPlan& plan);
    void SetPosition(int joint, Sint32 urad, bool wake);
    void Report(Sint32 keyFrame, const Sint32* commanded);
    void FillReport(SetValueMessage* message, const Sint32* commanded);
    void FillEars(SetValueMessage* message) const;
    bool InMotion() const { return state_ == moverPREPARE_MTN || state_ == moverMTN; }

    MoverPort* port_;
    const RobotConstants* robot_;
    JointSet joints_;
    MoverState state_;
    Sint32 stateCount_;  // states entered so far, to recognise vectors of an earlier state
    bool filled_;        // whether the first vector was made
    int posture_;        // start-up posture to which the robot moves

    MtnFile motion_;
    MtnPlayer player_;
    char file_[MTN_NAME_SIZE];
    int loops_, keyFramesPerVector_;
    bool inMotion_[MAX_JOINTS];  // joints that the motion moves
    bool deferred_[MAX_JOINTS];  // joints with a position that waits for the end of the motion
    bool deferredWake_[MAX_JOINTS];
    Sint32 deferredGoal_[MAX_JOINTS];

    BatchJoint batch_[MAX_JOINTS];  // the buffer received last
    Sint32 numVectors_;             // vectors made so far
    int numUnderWay_;
    UnderWay underWay_[MAX_VECTORS_UNDER_WAY];  // oldest first
};

#endif  // MoverCore_h_DEFINED
