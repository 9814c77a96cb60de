/*
 * Temperature sensor of the body (wished for in Hohl 2004, section 5.5).  Webots has none; the
 * functions have the form of its other sensors.
 */

#ifndef DEVICE_THERMOMETER_H
#define DEVICE_THERMOMETER_H

#include "types.h"

#ifdef __cplusplus
extern "C" {
#endif

/* Both do nothing, because the value can always be read. */
void thermometer_enable(DeviceTag sensor, unsigned short ms);
void thermometer_disable(DeviceTag sensor);

/* Degrees Celsius; 0.0 for anything that is no temperature sensor. */
float thermometer_get_value(DeviceTag sensor);

#ifdef __cplusplus
}
#endif

#endif /* DEVICE_THERMOMETER_H */
