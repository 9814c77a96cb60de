/*
 * The first example of Hohl 2004, 5.3.1: an endless loop.  The wheels are a light, the device is
 * the distance sensor of the head.
 */
#include <robot.h>
#include <led.h>
#include <distance_sensor.h>

DeviceTag ir;
DeviceTag light;

void my_robot_reset() {
  ir = robot_get_device("PRM:/r1/c1/c2/c3/p1-Sensor:p1");
  light = robot_get_device("PRM:/r1/c1/c2/c3/l7-LED2:l7");
}

int main() {
  robot_live(my_robot_reset);
  for(;;) { /* infinite loop */
    if (distance_sensor_get_value(ir)>100)
      led_set(light,0);
    else
      led_set(light,10);
    robot_step(64); /* run for 64 ms */
  }
  return 0;
}
