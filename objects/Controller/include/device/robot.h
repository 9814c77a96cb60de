/*
 * The robot as a controller sees it (Hohl 2004, table 5.1 and section 5.3.3).
 *
 * A controller's main() calls robot_live() and robot_run() and returns.  Devices are named by
 * their CPC primitive locator (OPEN-R name), such as "PRM:/r1/c1/c2/c3/l1-LED2:l1".
 */

#ifndef DEVICE_ROBOT_H
#define DEVICE_ROBOT_H

#include "types.h"

#ifdef __cplusplus
extern "C" {
#endif

/* Calls `reset` once, now. */
void robot_live(void (*reset)(void));

/* Calls `die` once, when the robot is shut down. */
void robot_die(void (*die)(void));

/*
 * Runs the control loop: calls `run` at once, and then again and again, always with argument 0.
 * The result of `run` is the time until the next call in milliseconds.  Multiples of 8 are exact;
 * other numbers are rounded to a multiple of 8.
 * On the robot, robot_run() returns after the first call of `run`, and main() goes on.
 * A run function may call robot_run() itself; the new function is called from the next time on.
 */
void robot_run(int (*run)(int));

/*
 * Waits for `ms` milliseconds and returns 0, for a controller that is an endless loop.  Because a
 * controller on the robot cannot wait, robot_step() there ends main() with a message in the log.
 * Use robot_run() instead; docs/controllers.md says how.
 */
int robot_step(int ms);

/* Returns the tag (number) of the device with this name; 0 if there is no such device.  All
 * functions ignore the tag 0. */
DeviceTag robot_get_device(const char *name);

/* Returns 1 if there is a device with this name, else 0.  Unlike robot_get_device(), it does not
 * warn if there is no such device, so that a controller can be written for several models. */
int robot_has_device(const char *name);

/* Always returns 1, which means that the controller runs on the robot, not in a simulator. */
int robot_get_mode(void);

/* robot_battery_sensor_get_value() returns the remaining capacity in percent.  The other two
 * functions do nothing, because the value can always be read. */
void robot_battery_sensor_enable(unsigned short ms);
void robot_battery_sensor_disable(void);
float robot_battery_sensor_get_value(void);

/* Prints a text to the robot's console as printf() does, at most 239 characters. */
void robot_console_printf(const char *format, ...);

#ifdef __cplusplus
}
#endif

#endif /* DEVICE_ROBOT_H */
