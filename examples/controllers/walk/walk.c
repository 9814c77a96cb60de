/*
 * walk: walks ten cycles, stands still and waits.  A motion is played once, so the controller plays
 * it again when it is over.
 */

#include <device/led.h>
#include <device/mtn.h>
#include <device/robot.h>

#define TIME_STEP 32 /* ms */
#define CYCLES 10

static MTN *begin, *cycle, *end;
static MTN *playing; /* null: no motion plays */
static int cycles;
static DeviceTag mode;

static void
play(MTN *motion)
{
    playing = motion;
    mtn_play(motion);
}

static void
reset(void)
{
    mode = robot_get_device("PRM:/r1/c1/c2/c3/l7-LED2:l7");
    begin = mtn_new("WALKSTA.MTN");
    cycle = mtn_new("WALK.MTN");
    end = mtn_new("WALKEND.MTN");
    play(begin);
}

static int
run(int ms)
{
    (void)ms;
    led_set(mode, playing != 0);
    if (playing == 0 || !mtn_is_over(playing)) return TIME_STEP;
    if (playing == end) {
        playing = 0;
    } else if (cycles < CYCLES) {
        cycles++;
        play(cycle);
    } else {
        play(end);
    }
    return TIME_STEP;
}

int
main(void)
{
    robot_live(reset);
    robot_run(run);
    return 0;
}
