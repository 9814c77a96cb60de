//
// The commands of MoverCore: commands that move single joints or set their limits, the buffer of
// joint commands that a controller sends, and commands that play and stop motions.
//

#include "MoverCore.h"

#include <string.h>

// Sets the position of a joint immediately, or after the motion if a motion moves the joint.  A
// joint that is off is switched on if `wake` is true, and otherwise stays off.
void
MoverCore::SetPosition(int joint, Sint32 urad, bool wake)
{
    if (!wake && joints_.IsOff(joint)) return;
    if (InMotion() && inMotion_[joint]) {
        deferred_[joint] = true;
        deferredWake_[joint] = wake;
        deferredGoal_[joint] = urad;
    } else if (wake) {
        joints_.Wake(joint, urad);
    } else {
        joints_.SetGoal(joint, urad);
    }
}

void
MoverCore::MoveJoint(const MoverCommand& command)
{
    if (state_ < moverACCEPTING_COMMANDS) return;
    if (command.joint < 0 || command.joint >= robot_->numJoints) return;
    if (command.kind == moverkindPOSITION) SetPosition(command.joint, command.value, false);
    if (command.kind == moverkindTRACK) Track(command);
    if (command.kind == moverkindSPEED) joints_.SetSpeed(command.joint, command.value);
    if (command.kind == moverkindACCELERATION)
        joints_.SetAcceleration(command.joint, command.value);
}

// Moves a joint that follows a joint of another robot, whose position is sent again and again.  If
// the new position is near, the joint reaches it in `command.frames` frames, when the next position
// is due.  If it is far, the joint moves within its limits of speed and acceleration, as in the
// movement to the first key frame of a motion.
void
MoverCore::Track(const MoverCommand& command)
{
    const int joint = command.joint;
    if (joints_.IsOff(joint) || (InMotion() && inMotion_[joint])) return;
    const Sint32 way = command.value - joints_.Position(joint);
    if (command.frames < 1 || way >= PREPARE_LIMIT_URAD || -way >= PREPARE_LIMIT_URAD) {
        joints_.SetGoal(joint, command.value);
    } else {
        joints_.Track(joint, command.value, command.frames);
    }
}

// Returns the position at which a limp joint is held when it is switched on: the measured position
// of the joint.  If the joint has hardly moved, returns the position at which it was held before,
// so that the joint does not creep a little each time it is switched off and on.
Sint32
MoverCore::HoldPosition(int joint) const
{
    const Sint32 before = joints_.Position(joint);
    const Sint32 measured = port_->Measure(joint);
    const Sint32 difference = measured - before;
    return difference < CREEP_URAD && -difference < CREEP_URAD ? before : measured;
}

void
MoverCore::SwitchMotor(const MoverCommand& command)
{
    if (state_ < moverACCEPTING_COMMANDS || command.joint >= robot_->numJoints) return;
    const bool on = command.kind == moverkindMOTOR_ON;
    const bool all = command.joint < 0;
    const bool changesPower = all && on != joints_.HasPower();
    if (changesPower && on) joints_.SwitchPowerOn();
    if (changesPower && !on) {
        // Drops the deferred commands first, because Stop() would carry them out although power
        // goes off.
        memset(deferred_, 0, sizeof(deferred_));
        Stop();
        joints_.SwitchPowerOff();
    }
    const int first = all ? 0 : command.joint;
    const int last = all ? robot_->numJoints - 1 : command.joint;
    for (int j = first; j <= last; j++) {
        if (on && joints_.IsOff(j)) SetPosition(j, HoldPosition(j), true);
        if (on || joints_.IsOff(j)) continue;
        // Also drops a deferred command, because it would switch the joint on at the end of the
        // motion.
        joints_.TurnOff(j);
        deferred_[j] = false;
    }
    // Reports the change of motor power.  The key frame -1 means that no motion plays.
    if (changesPower) Report(-1, 0);
}

void
MoverCore::SetGain(const MoverCommand& command)
{
    if (state_ < moverACCEPTING_COMMANDS) return;
    if (command.joint < 0 || command.joint >= robot_->numJoints) return;
    joints_.SetGain(command.joint, command.gain);
}

void
MoverCore::CarryOut(const MoverCommand& command)
{
    switch (command.kind) {
    case moverkindMOTOR_OFF:
    case moverkindMOTOR_ON:
        SwitchMotor(command);
        break;
    case moverkindGAINS:
        SetGain(command);
        break;
    default:
        MoveJoint(command);
        break;
    }
}

void
MoverCore::Batch(const BatchMoverCommand& command)
{
    if (state_ < moverACCEPTING_COMMANDS) return;
    for (int j = 0; j < robot_->numJoints; j++) {
        const BatchJoint& old = batch_[j];
        const BatchJoint& now = command.joint[j];
        const bool isOff = (now.flags & batchMOTOR_OFF) != 0;
        const bool wasOff = (old.flags & batchMOTOR_OFF) != 0;
        const bool isGiven = (now.flags & batchPOSITION_GIVEN) != 0;
        const bool wasGiven = (old.flags & batchPOSITION_GIVEN) != 0;
        // Carries out only values that differ from the buffer before, because every buffer has the
        // values of all joints.  Otherwise each buffer would undo what the remote control has set
        // meanwhile.
        if (now.speed != old.speed) joints_.SetSpeed(j, now.speed);
        if (now.acceleration != old.acceleration) joints_.SetAcceleration(j, now.acceleration);
        if (isOff && !wasOff) {
            joints_.TurnOff(j);
            deferred_[j] = false;
        }
        // The same position counts as new after the joint was off, because servo_set_position()
        // also switches the joint on.
        const bool isNew = !wasGiven || now.position != old.position || wasOff;
        if (isGiven && isNew && !isOff) SetPosition(j, now.position, true);
        batch_[j] = now;
    }
}

bool
MoverCore::Play(const MoverCommand& command, const Uint8* bytes, size_t size, std::string* error)
{
    if (!AcceptsMotion()) {
        *error = std::string("JointMover is in state ") + MoverStateName(state_);
        return false;
    }
    if (!joints_.HasPower()) {
        *error = "motor power is off";
        return false;
    }
    if (!motion_.Read(bytes, size) || !motion_.MapTo(robot_)) {
        *error = motion_.Error();
        return false;
    }
    memcpy(file_, command.file, sizeof(file_));
    file_[sizeof(file_) - 1] = '\0';
    loops_ = command.loops < 1 ? 1 : command.loops;
    keyFramesPerVector_ =
        command.keyFramesPerVector > 0 ? command.keyFramesPerVector : DEFAULT_KEYFRAMES_PER_VECTOR;
    memset(inMotion_, 0, sizeof(inMotion_));
    for (int j = 0; j < motion_.NumJoints(); j++) {
        if (motion_.RobotJoint(j) >= 0) inMotion_[motion_.RobotJoint(j)] = true;
    }
    if (!NeedsPreparation()) {
        BeginMotion();
        return true;
    }
    for (int j = 0; j < motion_.NumJoints(); j++) {
        if (motion_.RobotJoint(j) < 0) continue;
        joints_.SetGoal(motion_.RobotJoint(j), motion_.Angle(0, j));
    }
    Enter(moverPREPARE_MTN);
    // Usually VectorEnded() begins the motion, when the joints have reached key frame 0.  But if no
    // joint has to move, perhaps no further vector is sent and ends, so the motion begins here.
    if (IsStateComplete()) BeginMotion();
    return true;
}

// Returns whether the robot must first move to key frame 0 of the motion.  This is so if a joint is
// far from its position in key frame 0, or if a joint waits for its gain.  Such a joint would jerk
// if the motion moved its set point before the gain is on (see JointSet::Wake()).  Always returns
// true for a motion of one key frame, because the movement to key frame 0 is the whole motion.
bool
MoverCore::NeedsPreparation() const
{
    if (motion_.NumKeyFrames() == 1) return true;
    for (int j = 0; j < motion_.NumJoints(); j++) {
        const int joint = motion_.RobotJoint(j);
        if (joint < 0) continue;
        if (joints_.IsWaiting(joint)) return true;
        const Sint32 difference = joints_.Position(joint) - motion_.Angle(0, j);
        if (difference >= PREPARE_LIMIT_URAD || -difference >= PREPARE_LIMIT_URAD) return true;
    }
    return false;
}

void
MoverCore::BeginMotion()
{
    player_.Start(&motion_, loops_, keyFramesPerVector_);
    Enter(moverMTN);
    Report(0, 0);
    // A motion of one key frame is over at its beginning, because a motion plays the frames between
    // its key frames.
    if (!player_.IsPlaying()) EndMotion();
}

void
MoverCore::Stop()
{
    if (!InMotion()) return;
    player_.Stop();
    for (int j = 0; j < robot_->numJoints; j++) {
        if (inMotion_[j]) joints_.Halt(j);
    }
    EndMotion();
}

void
MoverCore::EndMotion()
{
    // Calls Enter(), which reports the end of the motion, before file_ is cleared.  Report() says
    // that a motion is over only while file_ has the name of the motion.
    Enter(moverACCEPTING_COMMANDS);
    memset(file_, 0, sizeof(file_));
    memset(inMotion_, 0, sizeof(inMotion_));
    for (int j = 0; j < robot_->numJoints; j++) {
        if (!deferred_[j]) continue;
        deferred_[j] = false;
        SetPosition(j, deferredGoal_[j], deferredWake_[j]);
    }
}
