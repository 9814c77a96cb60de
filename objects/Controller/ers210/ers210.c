/*
 * The default controller, which shows that a controller runs: the eyes are lit one after the other,
 * up the left side and down the right side, and the tail wags.  The mode indicator on the head
 * blinks once per round of the eyes.  Other models lack some of these: the ERS-220 has no tail.
 */

#include <device/led.h>
#include <device/robot.h>
#include <device/servo.h>

#define NUM_EYES 6
#define TIME_STEP 64   /* ms */
#define STEPS_PER_WAG 12
#define WAG 0.26f      /* rad: 15 of the 22 degrees that the tail can move to each side */

static const char *const EYES[NUM_EYES] = {
    "PRM:/r1/c1/c2/c3/l1-LED2:l1", "PRM:/r1/c1/c2/c3/l2-LED2:l2", "PRM:/r1/c1/c2/c3/l3-LED2:l3",
    "PRM:/r1/c1/c2/c3/l6-LED2:l6", "PRM:/r1/c1/c2/c3/l5-LED2:l5", "PRM:/r1/c1/c2/c3/l4-LED2:l4"
};

static DeviceTag eyes[NUM_EYES];
static DeviceTag mode;
static DeviceTag tail;
static int step;

/* Returns the tag of a device; 0, which all functions ignore, if this model does not have it. */
static DeviceTag
device_if_any(const char *name)
{
    return robot_has_device(name) ? robot_get_device(name) : 0;
}

static void
reset(void)
{
    int i;
    for (i = 0; i < NUM_EYES; i++) eyes[i] = device_if_any(EYES[i]);
    mode = device_if_any("PRM:/r1/c1/c2/c3/l7-LED2:l7");
    tail = device_if_any("PRM:/r6/c1-Joint2:j1");
    servo_set_acceleration(tail, 5.0f); /* rad/s^2, near the largest */
}

static int
run(int ms)
{
    int i;
    (void)ms;
    for (i = 0; i < NUM_EYES; i++) led_set(eyes[i], i == step % NUM_EYES);
    led_set(mode, step % NUM_EYES == 0);
    servo_set_position(tail, step / STEPS_PER_WAG % 2 == 0 ? WAG : -WAG);
    step++;
    return TIME_STEP;
}

int
main(void)
{
    robot_live(reset);
    robot_run(run);
    return 0;
}
