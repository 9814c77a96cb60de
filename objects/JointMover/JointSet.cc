#include "JointSet.h"

#include "Angle.h"

JointSet::JointSet(MoverPort* port) : port_(port), robot_(0) {}

void
JointSet::Begin(const RobotConstants* robot)
{
    robot_ = robot;
    for (int j = 0; j < robot->numJoints; j++) {
        gain_[j] = gainOFF;
        wakeVector_[j] = -1;
        wakeGoal_[j] = 0;
        trajectory_[j].Reset(port_->Measure(j));
        SetSpeed(j, robot->joints[j].maxSpeedCdeg);
        SetAcceleration(j, robot->defaultAccelerationCdeg);
    }
}

void
JointSet::EnableAllGains()
{
    for (int j = 0; j < robot_->numJoints; j++) {
        port_->EnableGain(j);
        gain_[j] = gainON;
    }
}

void
JointSet::SetGoal(int joint, Sint32 urad)
{
    const JointConstants& limits = robot_->joints[joint];
    const Sint32 goal = Clamp(urad, limits.minUrad, limits.maxUrad);
    if (gain_[joint] == gainWAITING) {
        wakeGoal_[joint] = goal;
    } else {
        trajectory_[joint].SetGoal(goal);
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
JointSet::TurnOff(int joint)
{
    port_->DisableGain(joint);
    gain_[joint] = gainOFF;
    trajectory_[joint].Reset(trajectory_[joint].Position());
}

void
JointSet::Wake(int joint, Sint32 urad)
{
    if (gain_[joint] == gainOFF) {
        gain_[joint] = gainWAITING;
        wakeVector_[joint] = -1;
        trajectory_[joint].Reset(port_->Measure(joint));
    }
    SetGoal(joint, urad);
}

bool
JointSet::IsMoving(int joint) const
{
    return trajectory_[joint].IsMoving();
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
        port_->EnableGain(j);
        gain_[j] = gainON;
        trajectory_[j].SetGoal(wakeGoal_[j]);
    }
}
