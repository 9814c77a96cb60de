//
// The newest sensor values of the robot, in the order of RobotConstants.
//

#ifndef SensorValues_h_DEFINED
#define SensorValues_h_DEFINED

#include "FixedTypes.h"
#include "RobotDescription.h"

const Uint32 NO_SENSOR_FRAME = 0xffffffff;

struct SensorValues {
    Uint32 frame;                // frame number of the samples; NO_SENSOR_FRAME before the first
    Sint32 joint[MAX_JOINTS];    // measured positions, in urad (10^-6 rad)
    Sint32 sensor[MAX_SENSORS];  // in the unit that SensorConstants::kind says
};

#endif  // SensorValues_h_DEFINED
