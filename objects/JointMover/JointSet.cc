#include "JointSet.h"

#include "Angle.h"

JointSet::JointSet(MoverPort* port) : port_(port), robot_(0), hasPower_(true) {}

void
JointSet::Begin(const RobotConstants* robot)
{
    robot_ = robot;
    hasPower_ = true;
    for (int j = 0; j < robot->numJoints; j++) {
        gain_[j] = gainOFF;
        wakeVector_[j] = -1;
        wakeGoal_[j] = 0;
        for (int i = 0; i < 3; i++) pid_[j][i] = robot->joints[j].gain[i];
        trajectory_[j].Reset(port_->Measure(j));
        SetSpeed(j, robot->joints[j].maxSpeedCdeg);
        SetAcceleration(j, robot->defaultAccelerationCdeg);
    }
}

void
JointSet::EnableAllGains()
{
    for (int j = 0; j < robot_->numJoints; j++) {
        port_->EnableGain(j, pid_[j]);
        gain_[j] = gainON;
    }
}

void
JointSet::SetGoal(int joint, Sint32 urad)
{
    const JointConstants& limits = robot_->joints[joint];
    const Sint32 goal = Clamp(urad, limits.minUrad, limits.maxUrad);
    if (gain_[joint] == gainWAITING) {
        // Keeps the goal until the gain is on.  Before that, the vectors must command the measured
        // position, so that the joint does not jump when its gain is switched on (see Wake()).
        wakeGoal_[joint] = goal;
    } else {
        trajectory_[joint].SetGoal(goal);
    }
}

void
JointSet::Track(int joint, Sint32 urad, int frames)
{
    const JointConstants& limits = robot_->joints[joint];
    if (gain_[joint] == gainWAITING) {
        SetGoal(joint, urad);
    } else {
        trajectory_[joint].Track(Clamp(urad, limits.minUrad, limits.maxUrad), frames);
    }
}

void
JointSet::SetSpeed(int joint, Sint32 cdeg)
{
    const JointConstants& limits = robot_->joints[joint];
    trajectory_[joint].SetSpeed(Clamp(cdeg, limits.minSpeedCdeg, limits.maxSpeedCdeg));
}

void
JointSet::SetAcceleration(int joint, Sint32 cdeg)
{
    trajectory_[joint].SetAcceleration(
        Clamp(cdeg, robot_->minAccelerationCdeg, robot_->maxAccelerationCdeg));
}

void
JointSet::Halt(int joint)
{
    // Drops the goal, because the joint would move to it when its gain is on.
    if (gain_[joint] == gainWAITING) wakeGoal_[joint] = trajectory_[joint].Position();
    trajectory_[joint].Halt();
}

void
JointSet::TurnOff(int joint)
{
    port_->DisableGain(joint);
    gain_[joint] = gainOFF;
    // Ends the movement of the joint, because a limp joint that still counts as moving would make
    // JointMover send vectors and wait until the joint arrives.
    trajectory_[joint].Reset(trajectory_[joint].Position());
}

void
JointSet::SwitchPowerOff()
{
    // Switches the gains off first, because otherwise the robot's servo control would go on summing
    // up position errors, which it cannot reduce without motor power (BBS 143).
    for (int j = 0; j < robot_->numJoints; j++) TurnOff(j);
    hasPower_ = false;
    port_->SetMotorPower(false);
}

void
JointSet::SwitchPowerOn()
{
    port_->SetMotorPower(true);
    hasPower_ = true;
}

void
JointSet::SetGain(int joint, const Sint32 gain[3])
{
    for (int i = 0; i < 3; i++) pid_[joint][i] = gain[i];
    // Gains of a limp joint are only stored here, because EnableGain() would switch the joint on.
    if (gain_[joint] == gainON) port_->EnableGain(joint, pid_[joint]);
}

void
JointSet::Wake(int joint, Sint32 urad)
{
    // Does nothing while motor power is off, because only MOTOR_ON for all joints switches it on
    // again.  A position of a controller does not.
    if (!hasPower_) return;
    if (gain_[joint] == gainOFF) {
        gain_[joint] = gainWAITING;
        // The gain is enabled at the end of a vector that is still to be made (-1), because the
        // vectors under way were made before the joint was measured and do not command its measured
        // position.
        wakeVector_[joint] = -1;
        trajectory_[joint].Reset(port_->Measure(joint));
    }
    SetGoal(joint, urad);
}

bool
JointSet::IsMoving(int joint) const
{
    return IsWaiting(joint) || trajectory_[joint].IsMoving();
}

bool
JointSet::IsBusy() const
{
    for (int j = 0; j < robot_->numJoints; j++) {
        if (trajectory_[j].IsMoving() || (gain_[j] == gainWAITING && wakeVector_[j] < 0))
            return true;
    }
    return false;
}

void
JointSet::Step(Sint32 urad[MAX_JOINTS])
{
    for (int j = 0; j < robot_->numJoints; j++) urad[j] = trajectory_[j].Step();
}

void
JointSet::VectorMade(Sint32 vector)
{
    for (int j = 0; j < robot_->numJoints; j++) {
        if (gain_[j] == gainWAITING && wakeVector_[j] < 0) wakeVector_[j] = vector;
    }
}

void
JointSet::VectorEnded(Sint32 vector)
{
    for (int j = 0; j < robot_->numJoints; j++) {
        if (gain_[j] != gainWAITING || wakeVector_[j] != vector) continue;
        port_->EnableGain(j, pid_[j]);
        gain_[j] = gainON;
        trajectory_[j].SetGoal(wakeGoal_[j]);
    }
}
