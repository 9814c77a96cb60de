#include <device/robot.h>

#include "timing.h"

int
main(void)
{
    robot_live(timing_reset);
    robot_die(timing_die);
    for (;;) {
        timing_iteration();
        robot_step(TIME_STEP);
    }
    return 0;
}
