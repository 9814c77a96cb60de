#include "RobotDescription.h"

#include <string.h>

#include "RobotConstants.h"

const RobotConstants*
FindRobot(const char* design)
{
    for (int i = 0; i < NUM_ROBOTS; i++) {
        if (strcmp(ROBOTS[i].design, design) == 0) return &ROBOTS[i];
    }
    return 0;
}

const PostureConstants*
FindPosture(const RobotConstants* robot, const char* name)
{
    for (int i = 0; i < robot->numPostures; i++) {
        if (strcmp(robot->postures[i].name, name) == 0) return &robot->postures[i];
    }
    return 0;
}

// Returns the index of the element of `rows` with this locator; -1 when there is no such element.
// This is a template, because joints, LEDs, ears (plungers) and sensors are described by different
// types, and all these types have a locator.
template <class Row>
static int
FindLocator(const Row* rows, int numRows, const char* locator)
{
    for (int i = 0; i < numRows; i++) {
        if (strcmp(rows[i].locator, locator) == 0) return i;
    }
    return -1;
}

int
FindJoint(const RobotConstants* robot, const char* locator)
{
    return FindLocator(robot->joints, robot->numJoints, locator);
}

int
FindLed(const RobotConstants* robot, const char* locator)
{
    return FindLocator(robot->leds, robot->numLeds, locator);
}

int
FindPlunger(const RobotConstants* robot, const char* locator)
{
    return FindLocator(robot->plungers, robot->numPlungers, locator);
}

int
FindSensor(const RobotConstants* robot, const char* locator)
{
    return FindLocator(robot->sensors, robot->numSensors, locator);
}

int
CountSensors(const RobotConstants* robot, SensorGroup group)
{
    int count = 0;
    for (int i = 0; i < robot->numSensors; i++) {
        if (robot->sensors[i].group == group) count++;
    }
    return count;
}
