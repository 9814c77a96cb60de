//
// Reads sensor vectors of OVirtualRobotComm into SensorValues, for an OPEN-R object.  A sensor
// vector is a message with four samples of every sensor.
//

#ifndef SensorReader_h_DEFINED
#define SensorReader_h_DEFINED

#include <OPENR/ODataFormats.h>

#include "SensorValues.h"

class SensorReader {
public:
    SensorReader();

    // Opens the primitives (devices) of all joints and sensors.  Call this function in DoInit().
    OStatus Open(const RobotConstants* robot);

    // Returns the primitive id of joint number `joint`.
    OPrimitiveID Joint(int joint) const { return joint_[joint]; }

    // Reads the newest sample of every joint and sensor in `vector` into `values`.
    void Read(OSensorFrameVectorData* vector, SensorValues* values);

private:
    void FindElements(OSensorFrameVectorData* vector);
    int FindElement(OSensorFrameVectorData* vector, OPrimitiveID id, const char* locator) const;

    const RobotConstants* robot_;
    OPrimitiveID joint_[MAX_JOINTS];
    OPrimitiveID sensor_[MAX_SENSORS];
    bool isFound_;                  // whether jointElement_ and sensorElement_ are set
    // For each joint, the index of its element in a sensor vector; -1 if the vector has no such
    // element.
    int jointElement_[MAX_JOINTS];
    // For each sensor, the index of its element in a sensor vector; -1 if the vector has no such
    // element.
    int sensorElement_[MAX_SENSORS];
};

#endif  // SensorReader_h_DEFINED
