/*
 * sitstand: sits down, waits, stands up, waits, and so on.
 */

#include <device/mtn.h>
#include <device/robot.h>

#define TIME_STEP 64 /* ms */
#define REST 32      /* steps between two motions */

static MTN *motions[2];
static int next; /* index of the next motion */
static int rested;

static void
reset(void)
{
    motions[0] = mtn_new("SIT.MTN");
    motions[1] = mtn_new("STAND.MTN");
    if (mtn_get_error() != 0) robot_console_printf("sitstand: %s\n", mtn_get_error());
}

static int
run(int ms)
{
    (void)ms;
    if (!mtn_is_over(motions[1 - next])) return TIME_STEP;
    if (++rested < REST) return TIME_STEP;
    rested = 0;
    mtn_play(motions[next]);
    next = 1 - next;
    return TIME_STEP;
}

static void
die(void)
{
    mtn_delete(motions[0]);
    mtn_delete(motions[1]);
}

int
main(void)
{
    robot_live(reset);
    robot_die(die);
    robot_run(run);
    return 0;
}
