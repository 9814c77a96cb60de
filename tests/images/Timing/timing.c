#include "timing.h"

#include <device/led.h>
#include <device/robot.h>
#include <device/servo.h>

static DeviceTag eye, ear, tilt;
static int iteration;

void
timing_reset(void)
{
    eye = robot_get_device("PRM:/r1/c1/c2/c3/l1-LED2:l1");
    ear = robot_get_device("PRM:/r1/c1/c2/c3/e1-Joint3:j5");
    tilt = robot_get_device("PRM:/r1/c1-Joint2:j1");
}

/* The eye changes every time, the ear every second time, the joint every fourth. */
void
timing_iteration(void)
{
    iteration++;
    robot_console_printf("iteration %d\n", iteration);
    led_set(eye, iteration % 2);
    servo_set_position(ear, iteration / 2 % 2 == 0 ? 0.0f : 1.0f);
    servo_set_position(tilt, iteration / 4 % 2 == 0 ? -0.1f : -0.2f);
}

void
timing_die(void)
{
    robot_console_printf("the end\n");
}
