//
// JointMover without OPEN-R: the state machine of Hohl 2004, section 4.1.1, and the making
// of command vectors.
//
//   filling -> gains -> broadbase -> sleeping -> crouching -> standing -> accepting-commands
//   accepting-commands -> [prepare-mtn ->] mtn -> accepting-commands
//
// The object asks for a vector whenever it has a free region and the effector is ready,
// and tells when one has ended.  Nothing to move means no vector: the robot keeps its set
// points, and an idle dog costs no messages.
//

#ifndef MoverCore_h_DEFINED
#define MoverCore_h_DEFINED

#include <stddef.h>

#include <string>

#include "JointSet.h"
#include "MoverPort.h"
#include "MtnFile.h"
#include "MtnPlayer.h"

// Frames of a vector outside motions: 4 x 8 ms, the period of the sensor vectors.  Two vectors
// wait in the effector, so a command begins to act after 64 ms at most; the 128 ms of a full
// vector would make that 256 ms, and shorter ones would double the messages for less than a
// servo notices.
const int MANUAL_VECTOR_FRAMES = 4;

// Vectors on their way to the effector at any time, one playing and one behind it.
const int MAX_VECTORS_UNDER_WAY = 2;

// Play-back skips the way to the first key frame when no joint is this far from it (Hohl
// 2004, section 4.1.2: smaller than 45 degrees).
const Sint32 PREPARE_LIMIT_URAD = 785398;

// What the next command vector holds: every joint of the robot, in urad.
struct VectorPlan {
    int numFrames;  // 1 to MAX_VECTOR_FRAMES
    Sint32 urad[MAX_VECTOR_FRAMES][MAX_JOINTS];
};

class MoverCore {
public:
    // `port` must outlive the core.
    explicit MoverCore(MoverPort* port);

    // Start of the robot; measures all joints.
    void Begin(const RobotConstants* robot);

    MoverState State() const { return state_; }
    bool AcceptsMotion() const { return state_ == moverACCEPTING_COMMANDS; }

    // Makes the next vector; false when there is nothing to send.  At most
    // MAX_VECTORS_UNDER_WAY may be under way.
    bool NextVector(VectorPlan* plan);

    // The oldest vector under way has ended.
    void VectorEnded();

    // Position, speed or acceleration of one joint, from the remote control.  Has no
    // effect before the robot stands and on joints that are switched off.  A joint that
    // a motion moves goes to the position when the motion is over.
    void MoveJoint(const MoverCommand& command);

    // The buffer of a controller; what differs from the one before is done.  Besides what
    // MoveJoint() does, it switches joints off and on again.
    void Batch(const BatchMoverCommand& command);

    // Begins a motion from the bytes of a file.  Returns false with a reason when they are no
    // motion for this robot, or when the robot is not accepting commands.
    bool Play(const MoverCommand& command, const Uint8* bytes, size_t size, std::string* error);

    // Ends a motion, or the way to it, where it is.
    void Stop();

    // Says on SetValue that the motion `command` asked for is over; nothing else changes.
    void ReportRefusal(const MoverCommand& command);

private:
    struct UnderWay {
        Sint32 number;
        Sint32 stateCount;  // stateCount_ when it was made
        Sint32 keyFrame;
        bool arrived;                  // the aim of the state is reached at its end
        Sint32 commanded[MAX_JOINTS];  // at its end
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
    Sint32 stateCount_;  // of states entered: tells vectors of an older state from those of this
    bool filled_;        // the first vector has been made
    int posture_;        // of the start-up, being approached

    MtnFile motion_;
    MtnPlayer player_;
    char file_[MTN_NAME_SIZE];
    int loops_, keyFramesPerVector_;
    bool inMotion_[MAX_JOINTS];  // moved by the motion
    bool deferred_[MAX_JOINTS];  // a position waits for the end of the motion
    bool deferredWake_[MAX_JOINTS];
    Sint32 deferredGoal_[MAX_JOINTS];

    BatchJoint batch_[MAX_JOINTS];  // as received last
    Sint32 numVectors_;             // made so far
    int numUnderWay_;
    UnderWay underWay_[MAX_VECTORS_UNDER_WAY];  // oldest first
};

#endif  // MoverCore_h_DEFINED
