/*
 * lights: switches the lights of the face on one after the other, up the left side and down the
 * right side.
 */

#include <device/led.h>
#include <device/robot.h>

#define NUM_LIGHTS 6
#define TIME_STEP 128 /* ms */

static const char *const NAMES[NUM_LIGHTS] = {
    "PRM:/r1/c1/c2/c3/l1-LED2:l1", "PRM:/r1/c1/c2/c3/l2-LED2:l2", "PRM:/r1/c1/c2/c3/l3-LED2:l3",
    "PRM:/r1/c1/c2/c3/l6-LED2:l6", "PRM:/r1/c1/c2/c3/l5-LED2:l5", "PRM:/r1/c1/c2/c3/l4-LED2:l4"
};

static DeviceTag lights[NUM_LIGHTS];
static int step;

static void
reset(void)
{
    int i;
    for (i = 0; i < NUM_LIGHTS; i++) lights[i] = robot_get_device(NAMES[i]);
}

static int
run(int ms)
{
    int i;
    (void)ms;
    for (i = 0; i < NUM_LIGHTS; i++) led_set(lights[i], i == step % NUM_LIGHTS);
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
