/*
 * Joints and, with servo_set_position() only, ears (Hohl 2004, sections 5.3.4 to 5.3.6).
 *
 * The units are radians, radians/s and radians/s^2.  A value beyond a limit of the robot becomes
 * the limit.
 */

#ifndef DEVICE_SERVO_H
#define DEVICE_SERVO_H

#include "types.h"

#ifdef __cplusplus
extern "C" {
#endif

/* servo_enable_position() and servo_disable_position() do nothing, because positions can always be
 * read. */
void servo_enable_position(DeviceTag servo, unsigned short ms);
void servo_disable_position(DeviceTag servo);

/* Returns the measured position of a joint; 0.0 for ears and other devices. */
float servo_get_position(DeviceTag servo);

/* Moves a joint to `position`, and switches its motor on if it was off.  An ear is switched on when
 * `position` is 0.0, otherwise off. */
void servo_set_position(DeviceTag servo, float position);
void servo_set_velocity(DeviceTag servo, float velocity);
void servo_set_acceleration(DeviceTag servo, float acceleration);

/* Does nothing: the largest torque of a joint does not change. */
void servo_set_force(DeviceTag servo, float force);

/* Switches the motor of a joint off until servo_set_position().  The joint becomes limp. */
void servo_motor_off(DeviceTag servo);

#ifdef __cplusplus
}
#endif

#endif /* DEVICE_SERVO_H */
