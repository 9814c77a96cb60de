/*
 * Acceleration sensors: an API of later Webots versions, not one of Hohl 2004, table 5.1.
 */

#ifndef DEVICE_ACCELEROMETER_H
#define DEVICE_ACCELEROMETER_H

#include "types.h"

#ifdef __cplusplus
extern "C" {
#endif

/* Both do nothing, because the values can always be read. */
void accelerometer_enable(DeviceTag sensor, unsigned short ms);
void accelerometer_disable(DeviceTag sensor);

/*
 * Three values in m/s^2, towards the front, the right and up as the robot has them (its primitives
 * a1, a2, a3; `sensor` may be any of them).  They stay until the next call.  0.0 three times for
 * anything that is no acceleration sensor; never a null pointer.
 */
const float *accelerometer_get_values(DeviceTag sensor);

#ifdef __cplusplus
}
#endif

#endif /* DEVICE_ACCELEROMETER_H */
