#include "DeviceTable.h"

#include <string.h>

int
DeviceTable::Find(const char* locator) const
{
    if (robot_ == 0 || locator == 0) return 0;
    int index = FindJoint(robot_, locator);
    if (index >= 0) return 1 + index;
    index = FindLed(robot_, locator);
    if (index >= 0) return FirstLed() + index;
    index = FindPlunger(robot_, locator);
    if (index >= 0) return FirstEar() + index;
    index = FindSensor(robot_, locator);
    if (index >= 0) return FirstSensor() + index;
    return strcmp(robot_->camera.locator, locator) == 0 ? CameraTag() : 0;
}

std::vector<const char*>
DeviceTable::Locators() const
{
    std::vector<const char*> all;
    if (robot_ == 0) return all;
    for (int i = 0; i < robot_->numJoints; i++) all.push_back(robot_->joints[i].locator);
    for (int i = 0; i < robot_->numLeds; i++) all.push_back(robot_->leds[i].locator);
    for (int i = 0; i < robot_->numPlungers; i++) all.push_back(robot_->plungers[i].locator);
    for (int i = 0; i < robot_->numSensors; i++) all.push_back(robot_->sensors[i].locator);
    all.push_back(robot_->camera.locator);
    return all;
}

int
DeviceTable::InRange(int tag, int first, int count) const
{
    return tag >= first && tag < first + count ? tag - first : -1;
}

int
DeviceTable::Joint(int tag) const
{
    return robot_ == 0 ? -1 : InRange(tag, 1, robot_->numJoints);
}

int
DeviceTable::Led(int tag) const
{
    return robot_ == 0 ? -1 : InRange(tag, FirstLed(), robot_->numLeds);
}

int
DeviceTable::Ear(int tag) const
{
    return robot_ == 0 ? -1 : InRange(tag, FirstEar(), robot_->numPlungers);
}

int
DeviceTable::Sensor(int tag) const
{
    return robot_ == 0 ? -1 : InRange(tag, FirstSensor(), robot_->numSensors);
}

bool
DeviceTable::IsCamera(int tag) const
{
    return robot_ != 0 && tag == CameraTag();
}
