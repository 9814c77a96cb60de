/*
 * posture: switches the motors of the head off so that you can move it by hand, and stores its
 * position.  Then the head looks straight ahead, and goes back to the stored position.  The mode
 * indicator is on while the motors are off.
 */

#include <device/led.h>
#include <device/robot.h>
#include <device/servo.h>

#define NUM_JOINTS 3
#define TIME_STEP 64 /* ms */
#define LIMP 48      /* steps in which the head can be moved */
#define AHEAD 48     /* steps until the head goes back */

static const char *const NAMES[NUM_JOINTS] = {
    "PRM:/r1/c1-Joint2:j1", "PRM:/r1/c1/c2-Joint2:j2", "PRM:/r1/c1/c2/c3-Joint2:j3"
};

static DeviceTag joints[NUM_JOINTS];
static DeviceTag mode;
static float posture[NUM_JOINTS];
static int step;

static void
reset(void)
{
    int i;
    for (i = 0; i < NUM_JOINTS; i++) {
        joints[i] = robot_get_device(NAMES[i]);
        servo_enable_position(joints[i], TIME_STEP);
        servo_motor_off(joints[i]);
    }
    mode = robot_get_device("PRM:/r1/c1/c2/c3/l7-LED2:l7");
}

static void
record(void)
{
    int i;
    for (i = 0; i < NUM_JOINTS; i++) posture[i] = servo_get_position(joints[i]);
    robot_console_printf("posture: %d %d %d mrad\n", (int)(posture[0] * 1000),
                         (int)(posture[1] * 1000), (int)(posture[2] * 1000));
}

static int
run(int ms)
{
    int i;
    (void)ms;
    if (step == LIMP) record();
    for (i = 0; i < NUM_JOINTS && step == LIMP; i++) servo_set_position(joints[i], 0.0f);
    for (i = 0; i < NUM_JOINTS && step == LIMP + AHEAD; i++)
        servo_set_position(joints[i], posture[i]);
    led_set(mode, step < LIMP);
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
