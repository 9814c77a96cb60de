/*
 * paws: reacts to the switches of the paws.  A paw that leaves the floor switches on a light on its
 * side, and the head turns to a lifted fore paw.
 */

#include <device/led.h>
#include <device/robot.h>
#include <device/servo.h>
#include <device/touch_sensor.h>

#define NUM_PAWS 4   /* left fore, left hind, right fore, right hind */
#define TIME_STEP 32 /* ms */
#define TURN 0.35f   /* rad */

static const char *const PAWS[NUM_PAWS] = {
    "PRM:/r2/c1/c2/c3/c4-Sensor:s4", "PRM:/r3/c1/c2/c3/c4-Sensor:s4",
    "PRM:/r4/c1/c2/c3/c4-Sensor:s4", "PRM:/r5/c1/c2/c3/c4-Sensor:s4"
};
static const char *const LIGHTS[NUM_PAWS] = {
    "PRM:/r1/c1/c2/c3/l3-LED2:l3", "PRM:/r1/c1/c2/c3/l1-LED2:l1",
    "PRM:/r1/c1/c2/c3/l6-LED2:l6", "PRM:/r1/c1/c2/c3/l4-LED2:l4"
};

static DeviceTag paws[NUM_PAWS], lights[NUM_PAWS];
static DeviceTag pan;

static void
reset(void)
{
    int i;
    for (i = 0; i < NUM_PAWS; i++) {
        paws[i] = robot_get_device(PAWS[i]);
        lights[i] = robot_get_device(LIGHTS[i]);
        touch_sensor_enable(paws[i], TIME_STEP);
    }
    pan = robot_get_device("PRM:/r1/c1/c2-Joint2:j2");
}

static int
run(int ms)
{
    int is_up[NUM_PAWS];
    int i;
    (void)ms;
    for (i = 0; i < NUM_PAWS; i++) {
        is_up[i] = !touch_sensor_get_value(paws[i]);
        led_set(lights[i], (unsigned char)is_up[i]);
    }
    servo_set_position(pan, TURN * (is_up[0] - is_up[2]));
    return TIME_STEP;
}

int
main(void)
{
    robot_live(reset);
    robot_run(run);
    return 0;
}
