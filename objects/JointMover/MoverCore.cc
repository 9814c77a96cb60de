#include "MoverCore.h"

#include <string.h>

#include "Angle.h"

// The postures of the start-up, in order, and the state in which the robot moves to each of them.
// A posture that the model of the robot does not have is left out.
struct StartPosture {
    MoverState state;
    const char* name;
};
static const StartPosture START_POSTURES[] = {
    { moverBROADBASE, "broadbase" },
    { moverSLEEPING, "sleep" },
    { moverCROUCHING, "crouch" },
    { moverSTANDING, "stand" },
};
static const int NUM_START_POSTURES = sizeof(START_POSTURES) / sizeof(START_POSTURES[0]);

MoverCore::MoverCore(MoverPort* port)
    : port_(port),
      robot_(0),
      joints_(port),
      state_(moverFILLING),
      stateCount_(0),
      filled_(false),
      posture_(0),
      loops_(1),
      keyFramesPerVector_(DEFAULT_KEYFRAMES_PER_VECTOR),
      numVectors_(0),
      numUnderWay_(0)
{
    memset(file_, 0, sizeof(file_));
    memset(inMotion_, 0, sizeof(inMotion_));
    memset(deferred_, 0, sizeof(deferred_));
    memset(deferredWake_, 0, sizeof(deferredWake_));
    memset(deferredGoal_, 0, sizeof(deferredGoal_));
    memset(batch_, 0, sizeof(batch_));
    memset(underWay_, 0, sizeof(underWay_));
}

void
MoverCore::Begin(const RobotConstants* robot)
{
    robot_ = robot;
    joints_.Begin(robot);
    for (int j = 0; j < robot->numJoints; j++) {
        // Controller's buffer begins with the same values.  Batch() carries out only differences,
        // so the first buffer changes only what the program has set.
        batch_[j].speed = robot->joints[j].maxSpeedCdeg;
        batch_[j].acceleration = robot->defaultAccelerationCdeg;
    }
    Enter(moverFILLING);
}

void
MoverCore::Enter(MoverState state)
{
    state_ = state;
    stateCount_++;
    port_->StateChanged(state);
    // Reports nothing for moverMTN, because BeginMotion() reports the beginning of a motion
    // together with key frame 0.
    if (state != moverMTN) Report(-1, 0);
}

// ---- Making vectors ------------------------------------------------------------------

bool
MoverCore::NextVector(VectorPlan* plan)
{
    if (robot_ == 0 || numUnderWay_ == MAX_VECTORS_UNDER_WAY) return false;
    // Begins the motion if all joints are at its first key frame and no vector is under way.
    // Usually the motion begins at the end of the last vector that moves joints to this key frame.
    // If such joints were switched off before, this vector may never be sent, so the motion begins
    // here.
    if (state_ == moverPREPARE_MTN && numUnderWay_ == 0 && IsStateComplete()) BeginMotion();
    if (state_ == moverFILLING) {
        // Sends a single vector with the measured positions and waits for its end: the gains are
        // enabled only then, so that no joint jerks.
        if (filled_) return false;
        filled_ = true;
        plan->numFrames = MANUAL_VECTOR_FRAMES;
    } else if (state_ == moverMTN && player_.IsPlaying()) {
        plan->numFrames = player_.FramesOfNextVector();
    } else if (joints_.IsBusy()) {
        plan->numFrames = MANUAL_VECTOR_FRAMES;
    } else {
        return false;
    }
    memset(plan->urad, 0, sizeof(plan->urad));
    for (int f = 0; f < plan->numFrames; f++) MakeFrame(plan->urad[f]);
    Remember(*plan);
    return true;
}

// Advances all joints by one frame.  Joints that the motion does not move carry out commands for
// single joints, so for example the tail can wag while the robot walks.
void
MoverCore::MakeFrame(Sint32 urad[MAX_JOINTS])
{
    joints_.Step(urad);
    if (state_ != moverMTN || !player_.IsPlaying()) return;
    player_.NextFrame();
    for (int j = 0; j < motion_.NumJoints(); j++) {
        const int joint = motion_.RobotJoint(j);
        if (joint < 0) continue;
        const JointConstants& limits = robot_->joints[joint];
        urad[joint] = Clamp(player_.Position(j), limits.minUrad - MTN_LIMIT_TOLERANCE_URAD,
                            limits.maxUrad + MTN_LIMIT_TOLERANCE_URAD);
        // Stores the position in joints_, too, so that the next command for this single joint
        // begins at the position where the motion has left it.
        joints_.Place(joint, urad[joint]);
    }
}

void
MoverCore::Remember(const VectorPlan& plan)
{
    UnderWay& record = underWay_[numUnderWay_++];
    record.number = numVectors_++;
    record.stateCount = stateCount_;
    record.keyFrame = state_ == moverMTN ? player_.KeyFrame() : -1;
    record.completesState = IsStateComplete();
    memcpy(record.commanded, plan.urad[plan.numFrames - 1], sizeof(record.commanded));
    joints_.VectorMade(record.number);
}

// Returns whether the newest frame completes the present state of MoverCore, such as "standing":
// all joints have reached their goals, or the motion is over.
bool
MoverCore::IsStateComplete() const
{
    if (state_ == moverMTN) return !player_.IsPlaying();
    for (int j = 0; j < robot_->numJoints; j++) {
        const bool counts = state_ == moverPREPARE_MTN ? inMotion_[j] : true;
        if (counts && joints_.IsMoving(j)) return false;
    }
    return true;
}

void
MoverCore::VectorEnded()
{
    if (numUnderWay_ == 0) return;
    const UnderWay ended = underWay_[0];
    // Moving one record is enough, because underWay_ has only two (MAX_VECTORS_UNDER_WAY).
    underWay_[0] = underWay_[1];
    numUnderWay_--;
    joints_.VectorEnded(ended.number);
    // Ignores a vector that was made in an earlier state, such as a vector of a motion that was
    // stopped, because this vector must not advance the present state.
    if (ended.stateCount != stateCount_) return;
    if (state_ == moverMTN) Report(ended.keyFrame, ended.commanded);
    if (ended.completesState) Advance();
}

// ---- States --------------------------------------------------------------------------

void
MoverCore::Advance()
{
    switch (state_) {
    case moverFILLING:
        Enter(moverGAINS);
        joints_.EnableAllGains();
        EnterPosture(0);
        break;
    case moverBROADBASE:
    case moverSLEEPING:
    case moverCROUCHING:
    case moverSTANDING:
        EnterPosture(posture_ + 1);
        break;
    case moverPREPARE_MTN:
        BeginMotion();
        break;
    case moverMTN:
        EndMotion();
        break;
    default:
        break;
    }
}

// Searches the start-up postures from `index` on.  Skips the postures that the robot's model lacks
// and the postures that the robot is already in, and begins the movement to the first posture that
// is left.
void
MoverCore::EnterPosture(int index)
{
    for (posture_ = index; posture_ < NUM_START_POSTURES; posture_++) {
        if (!SetPostureGoals(posture_)) continue;
        Enter(START_POSTURES[posture_].state);
        // Goes on to the next posture at once if no joint has to move: vectors are made only while
        // a joint moves, so the end of a vector, which calls Advance(), would never come.
        if (!IsStateComplete()) return;
    }
    Enter(moverACCEPTING_COMMANDS);
    port_->InitialPostureReached();
}

bool
MoverCore::SetPostureGoals(int index)
{
    const PostureConstants* posture = FindPosture(robot_, START_POSTURES[index].name);
    if (posture == 0) return false;
    for (int j = 0; j < robot_->numJoints; j++) joints_.SetGoal(j, posture->urad[j]);
    return true;
}

void
MoverCore::Report(Sint32 keyFrame, const Sint32* commanded)
{
    SetValueMessage message;
    FillReport(&message, commanded);
    message.keyFrame = keyFrame;
    message.isOver = state_ == moverACCEPTING_COMMANDS && file_[0] != '\0';
    memcpy(message.file, file_, sizeof(message.file));
    if (keyFrame >= 0) FillEars(&message);
    port_->Report(message);
}

// Fills in the states of the ears (plungers).  Takes the states of the key frame reached last,
// because ears are not interpolated.
void
MoverCore::FillEars(SetValueMessage* message) const
{
    for (int j = 0; j < motion_.NumJoints(); j++) {
        const int plunger = motion_.RobotPlunger(j);
        if (plunger < 0) continue;
        message->earMask = (Uint8)(message->earMask | 1 << plunger);
        if (motion_.Angle(message->keyFrame, j) == 0) continue;
        message->earOn = (Uint8)(message->earOn | 1 << plunger);
    }
}

void
MoverCore::ReportRefusal(const MoverCommand& command)
{
    SetValueMessage message;
    FillReport(&message, 0);
    // Gives the key frame of the motion that plays, if there is one.  This motion goes on, because
    // only the motion of `command` was refused.
    message.keyFrame = state_ == moverMTN ? player_.KeyFrame() : -1;
    message.isOver = 1;
    memcpy(message.file, command.file, sizeof(message.file) - 1);
    port_->Report(message);
}

void
MoverCore::FillReport(SetValueMessage* message, const Sint32* commanded)
{
    memset(message, 0, sizeof(*message));
    message->state = state_;
    message->keyFrame = -1;
    message->motorsOff = joints_.HasPower() ? 0 : 1;
    for (int j = 0; j < robot_->numJoints; j++) {
        message->commanded[j] = commanded != 0 ? commanded[j] : joints_.Position(j);
        message->measured[j] = port_->Measure(j);
    }
}
