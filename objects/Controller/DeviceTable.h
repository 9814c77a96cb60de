//
// The tags of a robot's devices.  A tag is the number that robot_get_device() returns.  Tags count
// from 1: first the joints, then the LEDs, the ears, the sensors and the camera.
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

    // Returns the index of a joint in RobotConstants::joints; -1 when `tag` is no joint's tag.
    int Joint(int tag) const;
    // Returns the index of an LED in RobotConstants::leds; -1 when `tag` is no LED's tag.
    int Led(int tag) const;
    // Returns the index of an ear in RobotConstants::plungers, the list of ears; -1 when `tag` is
    // no ear's tag.
    int Ear(int tag) const;
    // Returns the index of a sensor in RobotConstants::sensors; -1 when `tag` is no sensor's tag.
    int Sensor(int tag) const;
    bool IsCamera(int tag) const;

private:
    int InRange(int tag, int first, int count) const;
    int FirstLed() const { return 1 + robot_->numJoints; }
    int FirstEar() const { return FirstLed() + robot_->numLeds; }
    int FirstSensor() const { return FirstEar() + robot_->numPlungers; }
    int CameraTag() const { return FirstSensor() + robot_->numSensors; }

    const RobotConstants* robot_;  // the robot; 0 if there is none, and then there are no devices
};

#endif  // DeviceTable_h_DEFINED
