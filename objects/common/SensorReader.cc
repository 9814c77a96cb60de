#include "SensorReader.h"

#include <OPENR/OPENRAPI.h>
#include <OPENR/OSyslog.h>

SensorReader::SensorReader() : robot_(0), isFound_(false)
{
    for (int j = 0; j < MAX_JOINTS; j++) jointElement_[j] = -1;
    for (int i = 0; i < MAX_SENSORS; i++) sensorElement_[i] = -1;
}

OStatus
SensorReader::Open(const RobotConstants* robot)
{
    robot_ = robot;
    for (int j = 0; j < robot->numJoints; j++) {
        const OStatus status = OPENR::OpenPrimitive(robot->joints[j].locator, &joint_[j]);
        if (status != oSUCCESS) return status;
    }
    for (int i = 0; i < robot->numSensors; i++) {
        const OStatus status = OPENR::OpenPrimitive(robot->sensors[i].locator, &sensor_[i]);
        if (status != oSUCCESS) return status;
    }
    return oSUCCESS;
}

// Returns the index of the element of a sensor vector that has primitive `id`; -1 when the vector
// has no such element.  Called for the first vector only, because an element has the same index in
// every vector.
int
SensorReader::FindElement(OSensorFrameVectorData* vector, OPrimitiveID id,
                          const char* locator) const
{
    const int numElements = (int)vector->vectorInfo.numData;
    for (int i = 0; i < numElements; i++) {
        if (vector->GetInfo(i)->primitiveID == id) return i;
    }
    OSYSLOG1((osyslogERROR, "%s is not in the sensor vector", locator));
    return -1;
}

void
SensorReader::FindElements(OSensorFrameVectorData* vector)
{
    isFound_ = true;
    for (int j = 0; j < robot_->numJoints; j++) {
        jointElement_[j] = FindElement(vector, joint_[j], robot_->joints[j].locator);
    }
    for (int i = 0; i < robot_->numSensors; i++) {
        sensorElement_[i] = FindElement(vector, sensor_[i], robot_->sensors[i].locator);
    }
}

static Sint32
NewestValue(OSensorFrameVectorData* vector, int element)
{
    if (element < 0) return 0;
    const int newest = (int)vector->GetInfo(element)->numFrames - 1;
    return newest >= 0 ? vector->GetData(element)->frame[newest].value : 0;
}

void
SensorReader::Read(OSensorFrameVectorData* vector, SensorValues* values)
{
    if (!isFound_) FindElements(vector);
    for (int j = 0; j < robot_->numJoints; j++) {
        values->joint[j] = NewestValue(vector, jointElement_[j]);
    }
    for (int i = 0; i < robot_->numSensors; i++) {
        values->sensor[i] = NewestValue(vector, sensorElement_[i]);
    }
    const OSensorFrameInfo* info = vector->GetInfo(0);
    values->frame = info->frameNumber + info->numFrames - 1;
}
