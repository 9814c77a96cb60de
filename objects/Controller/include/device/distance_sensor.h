/*
 * The distance sensor in the head (Hohl 2004, section 5.3.5).
 */

#ifndef DEVICE_DISTANCE_SENSOR_H
#define DEVICE_DISTANCE_SENSOR_H

#include "types.h"

#ifdef __cplusplus
extern "C" {
#endif

/* distance_sensor_enable() and distance_sensor_disable() do nothing, because the value can
 * always be read. */
void distance_sensor_enable(DeviceTag sensor, unsigned short ms);
void distance_sensor_disable(DeviceTag sensor);

/* Returns the distance in millimetres, 100 to 900; 0 for any other device. */
unsigned short distance_sensor_get_value(DeviceTag sensor);

#ifdef __cplusplus
}
#endif

#endif /* DEVICE_DISTANCE_SENSOR_H */
