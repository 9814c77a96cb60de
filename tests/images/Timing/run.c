#include <device/robot.h>

#include "timing.h"

static int
run(int ms)
{
    (void)ms;
    timing_iteration();
    return TIME_STEP;
}

int
main(void)
{
    robot_live(timing_reset);
    robot_die(timing_die);
    robot_run(run);
    return 0;
}
