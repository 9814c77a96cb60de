// Steps inside of catch blocks, and ends by exit().
#include <device/led.h>
#include <device/robot.h>

#include <stdlib.h>

int
main()
{
    const DeviceTag eye = robot_get_device("PRM:/r1/c1/c2/c3/l1-LED2:l1");
    for (int i = 1; i <= 3; i++) {
        try {
            throw i;
        } catch (int caught) {
            led_set(eye, caught % 2);
            robot_step(32);
            robot_console_printf("caught %d\n", caught);
        }
    }
    exit(0);
}
