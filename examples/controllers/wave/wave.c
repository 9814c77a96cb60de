/*
 * wave: sits down, lifts the left fore leg, waves three times, puts it down and stands up.
 */

#include <device/mtn.h>
#include <device/robot.h>
#include <device/servo.h>

#define NUM_JOINTS 3
#define TIME_STEP 64 /* ms */
#define MOVE 20      /* steps that a movement of the leg takes */
#define WAVES 3

static DeviceTag leg[NUM_JOINTS];
static float sitting[NUM_JOINTS]; /* angles of the leg on the floor */
static MTN *sit, *stand;
static int step = -1; /* steps since the dog sat; -1: it does not sit yet */

static void
reset(void)
{
    leg[0] = robot_get_device("PRM:/r2/c1-Joint2:j1");
    leg[1] = robot_get_device("PRM:/r2/c1/c2-Joint2:j2");
    leg[2] = robot_get_device("PRM:/r2/c1/c2/c3-Joint2:j3");
    sit = mtn_new("SIT.MTN");
    stand = mtn_new("STAND.MTN");
    mtn_play(sit);
}

static void
move(float j1, float j2, float j3)
{
    servo_set_position(leg[0], j1);
    servo_set_position(leg[1], j2);
    servo_set_position(leg[2], j3);
}

/* Makes the n-th movement since the dog sat; returns 0 when no movement is left. */
static int
movement(int n)
{
    int i;
    if (n == 0) {
        for (i = 0; i < NUM_JOINTS; i++) sitting[i] = servo_get_position(leg[i]);
        move(1.2f, 0.3f, 0.6f); /* forward and up */
    } else if (n <= 2 * WAVES) {
        move(1.2f, n % 2 == 1 ? 0.7f : 0.2f, 0.6f);
    } else if (n == 2 * WAVES + 1) {
        move(sitting[0], sitting[1], sitting[2]);
    } else {
        return 0;
    }
    return 1;
}

static int
run(int ms)
{
    (void)ms;
    if (step < 0 && !mtn_is_over(sit)) return TIME_STEP;
    step++;
    if (step % MOVE == 0 && step / MOVE <= 2 * WAVES + 2 && !movement(step / MOVE)) mtn_play(stand);
    return TIME_STEP;
}

int
main(void)
{
    robot_live(reset);
    robot_run(run);
    return 0;
}
