/*
 * battery: shows the charge of the battery by the light of the tail, blue while there is enough.
 * When the battery is low, the dog lies down and the light blinks orange.
 */

#include <device/led.h>
#include <device/mtn.h>
#include <device/robot.h>

#define TIME_STEP 256 /* ms */
#ifndef LOW
#define LOW 20 /* % */
#endif

static DeviceTag blue, orange;
static MTN *lie;
static int is_low;
static int step;

static void
reset(void)
{
    blue = robot_get_device("PRM:/r6/l1-LED2:l1");
    orange = robot_get_device("PRM:/r6/l2-LED2:l2");
    lie = mtn_new("LIE.MTN");
    robot_battery_sensor_enable(TIME_STEP);
}

static int
run(int ms)
{
    (void)ms;
    if (!is_low && robot_battery_sensor_get_value() < LOW) {
        is_low = 1;
        mtn_play(lie);
    }
    led_set(blue, !is_low);
    led_set(orange, is_low && step % 2 == 0);
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
