//
// Reads sensor vectors of OVirtualRobotComm into SensorValues.  For use inside of an OPEN-R object.
//

#ifndef SensorReader_h_DEFINED
#define SensorReader_h_DEFINED

#include <OPENR/ODataFormats.h>

#include "SensorValues.h"

class SensorReader {
public:
    SensorReader();

    // Opens the primitives of all joints and sensors.  Call in DoInit.
    OStatus Open(const RobotConstants* robot);

    // Reads the newest of the frames in `vector`.
    void Read(OSensorFrameVectorData* vector, SensorValues* values);

private:
    void FindElements(OSensorFrameVectorData* vector);
    int FindElement(OSensorFrameVectorData* vector, OPrimitiveID id, const char* locator) const;

    const RobotConstants* robot_;
    OPrimitiveID joint_[MAX_JOINTS];
    OPrimitiveID sensor_[MAX_SENSORS];
    bool isFound_;                  // whether the elements below are known
    int jointElement_[MAX_JOINTS];  // element of the vector; -1: not in the vector
    int sensorElement_[MAX_SENSORS];
};

#endif  // SensorReader_h_DEFINED
