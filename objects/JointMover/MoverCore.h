//
// The part of JointMover that does not use OPEN-R: the state machine of Hohl 2004, section 4.1.1,
// which makes the command vectors.
//
//   filling -> gains -> broadbase -> sleeping -> crouching -> standing -> accepting-commands
//   accepting-commands -> [prepare-mtn ->] mtn -> accepting-commands
//
// A command vector is a message to the robot's effector with up to 16 frames of 8 ms for every
// joint.  JointMover asks for a vector whenever it has a free region and the effector is ready, and
// calls VectorEnded() when a vector has ended.  When no joint moves, no vector is made: the robot
// keeps its set points, and a robot that stands still costs no messages.
//

#ifndef MoverCore_h_DEFINED
#define MoverCore_h_DEFINED

#include <stddef.h>

#include <string>

#include "JointSet.h"
#include "MoverPort.h"
#include "MtnFile.h"
#include "MtnPlayer.h"

// Number of frames of a command vector outside of motions: 4 x 8 ms, which is the period of the
// sensor vectors.  Because two vectors are under way, a command begins to act after 64 ms at most.
// Full vectors of 128 ms would make this time 256 ms; shorter vectors would double the messages for
// little gain.
const int MANUAL_VECTOR_FRAMES = 4;

// Maximum number of command vectors that are under way, that is, sent to the robot and not ended:
// one plays and one waits.
const int MAX_VECTORS_UNDER_WAY = 2;

// Limit, in urad, of the distance between a joint and its angle in the first key frame (posture) of
// a motion.  When all joints are nearer, the motion begins without a movement to the first key
// frame (Hohl 2004, section 4.1.2: smaller than 45 degrees).
const Sint32 PREPARE_LIMIT_URAD = 785398;

// Distance, in urad, up to which a limp joint counts as not moved, so that it is held at its old
// position: 0.1 degree.
const Sint32 CREEP_URAD = 1745;

// The positions for the next command vector, for every joint of the robot, in urad (10^-6 rad).
struct VectorPlan {
    int numFrames;  // number of frames: 1 to MAX_VECTOR_FRAMES
    Sint32 urad[MAX_VECTOR_FRAMES][MAX_JOINTS];
};

class MoverCore {
public:
    // Makes a core.  `port` must outlive the core.
    explicit MoverCore(MoverPort* port);

    // Begins the start-up of the robot: reads the present angles of all joints, from which the
    // joints then move to the start-up postures.
    void Begin(const RobotConstants* robot);

    MoverState State() const { return state_; }
    bool AcceptsMotion() const { return state_ == moverACCEPTING_COMMANDS; }

    // Makes the next command vector.  Returns false when no vector is to be sent, or when
    // MAX_VECTORS_UNDER_WAY vectors have not ended yet.
    bool NextVector(VectorPlan* plan);

    // Records that the oldest vector under way has ended.  If the present state waited only for
    // this vector, enters the next state.
    void VectorEnded();

    // Carries out `command`, which may be of any kind except PLAY and STOP.  For these two kinds
    // the caller calls Play() or Stop() instead.
    void CarryOut(const MoverCommand& command);

    // Sets the position, speed or acceleration of one joint.  Has no effect before the robot
    // stands.  A position has no effect on a joint that is switched off.  If a motion moves the
    // joint, the joint goes to the new position after the motion, but a position of kind TRACK has
    // no effect.
    void MoveJoint(const MoverCommand& command);

    // Switches the motor of a joint off or on.  With MOVER_ALL_JOINTS, switches the power of all
    // motors; switching it off also ends a motion.  A joint that is off is switched on again by
    // this command or, while there is motor power, by a position in the buffer of a controller.  No
    // other command wakes it (Hohl 2004, section 5.3.6).
    void SwitchMotor(const MoverCommand& command);

    // Sets the P, I and D gain of the joint that `command` names.
    void SetGain(const MoverCommand& command);

    // Carries out the differences between `command`, the new buffer of a controller, and the buffer
    // that came before.  A buffer can also switch joints off and on again, which MoveJoint() cannot
    // do.
    void Batch(const BatchMoverCommand& command);

    // Begins the motion in `bytes`, the content of a motion file.  Returns false and sets `error`
    // when the bytes are no motion for this robot, or when the robot does not accept commands now.
    bool Play(const MoverCommand& command, const Uint8* bytes, size_t size, std::string* error);

    // Ends the motion, or the movement to its first key frame, at once.
    void Stop();

    // Tells the observers of the subject SetValue that the motion of `command` is over.  Called
    // when the motion was refused, so that no object waits for its end.  Does not change the state
    // of the core.
    void ReportRefusal(const MoverCommand& command);

private:
    struct UnderWay {
        Sint32 number;
        Sint32 stateCount;  // value of stateCount_ when the vector was made
        Sint32 keyFrame;
        bool completesState;           // whether MoverCore completes its state when the vector ends
        Sint32 commanded[MAX_JOINTS];  // positions at the end of the vector
    };

    void Enter(MoverState state);
    void Advance();
    void EnterPosture(int index);
    bool SetPostureGoals(int index);
    void BeginMotion();
    void EndMotion();
    bool NeedsPreparation() const;
    void Track(const MoverCommand& command);
    Sint32 HoldPosition(int joint) const;
    bool IsStateComplete() const;
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
    // Number of times that MoverCore has entered a state.  Each command vector stores this number,
    // which shows at the end of the vector whether the vector belongs to an earlier state.
    Sint32 stateCount_;
    bool filled_;  // whether the first vector (state moverFILLING) was made already
    int posture_;  // index of the start-up posture to which the robot moves

    MtnFile motion_;
    MtnPlayer player_;
    char file_[MTN_NAME_SIZE];
    int loops_, keyFramesPerVector_;
    bool inMotion_[MAX_JOINTS];  // for each joint, whether the motion moves it
    // For each joint, whether a command for its position waits until the motion has ended.
    bool deferred_[MAX_JOINTS];
    bool deferredWake_[MAX_JOINTS];
    Sint32 deferredGoal_[MAX_JOINTS];

    BatchJoint batch_[MAX_JOINTS];  // the buffer that was received last
    Sint32 numVectors_;             // number of vectors made so far
    int numUnderWay_;
    UnderWay underWay_[MAX_VECTORS_UNDER_WAY];  // the vectors under way, oldest first
};

#endif  // MoverCore_h_DEFINED
