/*
 * Acceleration sensors.  The functions are those of later versions of Webots; Hohl 2004, table 5.1,
 * does not have them.
 */

#ifndef DEVICE_ACCELEROMETER_H
#define DEVICE_ACCELEROMETER_H

#include "types.h"

#ifdef __cplusplus
extern "C" {
#endif

/* accelerometer_enable() and accelerometer_disable() do nothing, because the values can always be
 * read. */
void accelerometer_enable(DeviceTag sensor, unsigned short ms);
void accelerometer_disable(DeviceTag sensor);

/*
 * Returns three values in m/s^2: to the front, to the right and up, measured by the robot's
 * primitives a1, a2 and a3.  `sensor` may be any of the three.  The values stay valid until the
 * next call.  For any other device these values are 0.0; the result is never a null pointer.
 */
const float *accelerometer_get_values(DeviceTag sensor);

#ifdef __cplusplus
}
#endif

#endif /* DEVICE_ACCELEROMETER_H */
