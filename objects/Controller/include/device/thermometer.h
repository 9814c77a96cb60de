/*
 * The temperature sensor of the body (wished for in Hohl 2004, section 5.5).  Webots has no such
 * sensor; these functions have the same form as the functions of other sensors in Webots.
 */

#ifndef DEVICE_THERMOMETER_H
#define DEVICE_THERMOMETER_H

#include "types.h"

#ifdef __cplusplus
extern "C" {
#endif

/* thermometer_enable() and thermometer_disable() do nothing, because the value can always be
 * read. */
void thermometer_enable(DeviceTag sensor, unsigned short ms);
void thermometer_disable(DeviceTag sensor);

/* Returns the temperature in degrees Celsius; 0.0 for any other device. */
float thermometer_get_value(DeviceTag sensor);

#ifdef __cplusplus
}
#endif

#endif /* DEVICE_THERMOMETER_H */
