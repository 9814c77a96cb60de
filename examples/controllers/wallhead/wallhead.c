/*
 * wallhead: turns the head by the distance of an obstacle ahead: straight ahead when no obstacle is
 * near, and the further to the left the nearer the obstacle is.
 */

#include <device/distance_sensor.h>
#include <device/robot.h>
#include <device/servo.h>

#define TIME_STEP 64 /* ms */
#define FAR 900      /* mm, the range of the sensor */
#define TURN 0.001f  /* rad for each mm that the obstacle is nearer than FAR */

static DeviceTag pan, distance;

static void
reset(void)
{
    pan = robot_get_device("PRM:/r1/c1/c2-Joint2:j2");
    distance = robot_get_device("PRM:/r1/c1/c2/c3/p1-Sensor:p1");
    distance_sensor_enable(distance, TIME_STEP);
    servo_set_velocity(pan, 1.0f);
}

static int
run(int ms)
{
    (void)ms;
    servo_set_position(pan, TURN * (FAR - (int)distance_sensor_get_value(distance)));
    return TIME_STEP;
}

int
main(void)
{
    robot_live(reset);
    robot_run(run);
    return 0;
}
