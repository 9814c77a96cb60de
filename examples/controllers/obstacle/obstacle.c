/*
 * obstacle: walks until an obstacle is near, then stops and switches the red lights of the eyes on.
 */

#include <device/distance_sensor.h>
#include <device/led.h>
#include <device/robot.h>

#include "gait.h"

#define TIME_STEP 32 /* ms */
#define NEAR 450     /* mm; far enough, because a walk cycle is played to its end */

static DeviceTag distance, left, right;

static void
reset(void)
{
    distance = robot_get_device("PRM:/r1/c1/c2/c3/p1-Sensor:p1");
    left = robot_get_device("PRM:/r1/c1/c2/c3/l1-LED2:l1");
    right = robot_get_device("PRM:/r1/c1/c2/c3/l4-LED2:l4");
    distance_sensor_enable(distance, TIME_STEP);
    gait_load();
}

static int
run(int ms)
{
    const int is_near = distance_sensor_get_value(distance) < NEAR;
    (void)ms;
    gait_step(!is_near);
    led_set(left, is_near);
    led_set(right, is_near);
    return TIME_STEP;
}

int
main(void)
{
    robot_live(reset);
    robot_run(run);
    return 0;
}
