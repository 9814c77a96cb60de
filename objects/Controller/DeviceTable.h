//
// The tags of a robot's devices.  A tag is the number that robot_get_device() returns: from 1 for
// joints, LEDs, ears, sensors and the camera, in this order.
//

#ifndef DeviceTable_h_DEFINED
#define DeviceTable_h_DEFINED

#include <vector>

#include "RobotDescription.h"

class DeviceTable {
public:
    DeviceTable() : robot_(0) {}
    void Begin(const RobotConstants* robot) { robot_ = robot; }

    // Returns the tag of the device with this locator (its OPEN-R name); 0 if the robot has no such
    // device.
    int Find(const char* locator) const;

    // Returns the locators (OPEN-R names) of all devices of the robot.
    std::vector<const char*> Locators() const;

    // Joint(), Led(), Ear() and Sensor() return the index of the device in its table of
    // RobotConstants; -1 when `tag` is the tag of a device of another kind.
    int Joint(int tag) const;
    int Led(int tag) const;
    int Ear(int tag) const;
    int Sensor(int tag) const;
    bool IsCamera(int tag) const;

private:
    int InRange(int tag, int first, int count) const;
    int FirstLed() const { return 1 + robot_->numJoints; }
    int FirstEar() const { return FirstLed() + robot_->numLeds; }
    int FirstSensor() const { return FirstEar() + robot_->numPlungers; }
    int CameraTag() const { return FirstSensor() + robot_->numSensors; }

    const RobotConstants* robot_;  // the robot; 0 if there is none, so that there are no devices
};

#endif  // DeviceTable_h_DEFINED
