#include "MotionLog.h"

#include "Angle.h"

// Returns whether records of the log of motions have a position of `joint`.  The log has the same
// joints as the vendor's motion files, which lack mouth and tail.
static bool
IsLogged(const JointConstants& joint)
{
    return joint.mtnIndex >= 0;
}

// Returns whether `sensor` is the switch under a paw.  The locator tells this, because the legs are
// the parts r2 to r5 of every robot, and a leg has no other switch.
static bool
IsPaw(const SensorConstants& sensor)
{
    const char* locator = sensor.locator;  // such as "PRM:/r2/..."
    return sensor.group == sensorBINARY && locator[5] == 'r' && locator[6] >= '2' &&
           locator[6] <= '5';
}

void
MotionLog::Begin(const RobotConstants* robot)
{
    robot_ = robot;
    count_ = 0;
    numJoints_ = 0;
    for (int j = 0; j < robot->numJoints; j++) {
        if (IsLogged(robot->joints[j])) numJoints_++;
    }
}

void
MotionLog::Add(const SetValueMessage& report, const SensorValues& sensors)
{
    if (report.keyFrame < 0) return;
    RcWriter out(record_[count_ % CAPACITY], RC_MAX_LOG_RECORD);
    out.U16((Uint32)report.keyFrame);
    for (int j = 0; j < robot_->numJoints; j++) {
        if (IsLogged(robot_->joints[j])) out.U16((Uint32)CdegFromUrad(report.commanded[j]));
    }
    // Writes the number of measured values.  The number of simulated values, at the end of the
    // record, is 0 on a robot (Hohl 2004, table 3.9).
    out.U8((Uint32)(numJoints_ + RC_LOG_PAWS));
    for (int j = 0; j < robot_->numJoints; j++) {
        if (IsLogged(robot_->joints[j])) out.U16((Uint32)CdegFromUrad(report.measured[j]));
    }
    for (int i = 0; i < robot_->numSensors; i++) {
        if (IsPaw(robot_->sensors[i])) out.U16(sensors.sensor[i] != 0 ? 1 : 0);
    }
    out.U8(0);
    count_++;
}
