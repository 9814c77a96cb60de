/*
 * LEDs (Hohl 2004, section 5.3.4).
 */

#ifndef DEVICE_LED_H
#define DEVICE_LED_H

#include "types.h"

#ifdef __cplusplus
extern "C" {
#endif

/* Switches the LED off when `value` is 0, otherwise on.  The change is sent with the next command
 * of the control loop. */
void led_set(DeviceTag led, unsigned char value);

#ifdef __cplusplus
}
#endif

#endif /* DEVICE_LED_H */
