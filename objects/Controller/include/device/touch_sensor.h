/*
 * Paws, chin, back and head as touch sensors (Hohl 2004, section 5.3.5).
 */

#ifndef DEVICE_TOUCH_SENSOR_H
#define DEVICE_TOUCH_SENSOR_H

#include "types.h"

#ifdef __cplusplus
extern "C" {
#endif

/* touch_sensor_enable() and touch_sensor_disable() do nothing, because the value can always be
 * read. */
void touch_sensor_enable(DeviceTag sensor, unsigned short ms);
void touch_sensor_disable(DeviceTag sensor);

/*
 * Returns 1 when the sensor is touched, otherwise 0.  The head sensors count as touched when the
 * force exceeds half of their upper limit.  Returns 0 for any other device.
 */
unsigned short touch_sensor_get_value(DeviceTag sensor);

#ifdef __cplusplus
}
#endif

#endif /* DEVICE_TOUCH_SENSOR_H */
