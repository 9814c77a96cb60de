// Sensors that Hohl 2004 wished for, which have no interface in its table 5.1.
#include <device/accelerometer.h>
#include <device/thermometer.h>

#include "controller_fixture.h"

namespace openr_host {
namespace {

constexpr const char* kFront = "PRM:/a1-Sensor:a1";
constexpr const char* kRight = "PRM:/a2-Sensor:a2";
constexpr const char* kUp = "PRM:/a3-Sensor:a3";

class ControllerSensorTest : public ControllerTest {};

TEST_F(ControllerSensorTest, AccelerationsAreInMetresPerSecondSquaredByAxis) {
  Sense(kFront, -1500000);
  Sense(kRight, 250000);
  Sense(kUp, 9806650);
  for (const char* name : {kFront, kRight, kUp}) {
    const float* values = accelerometer_get_values(robot_get_device(name));
    EXPECT_FLOAT_EQ(values[0], -1.5f);
    EXPECT_FLOAT_EQ(values[1], 0.25f);
    EXPECT_FLOAT_EQ(values[2], 9.80665f);
  }
}

TEST_F(ControllerSensorTest, WhatIsNoAccelerometerReadsZeros) {
  Sense(kUp, 9806650);
  for (const DeviceTag tag : {robot_get_device(kPsd), DeviceTag{0}, DeviceTag{999}}) {
    const float* values = accelerometer_get_values(tag);
    EXPECT_EQ(values[0] + values[1] + values[2], 0.0f);
  }
}

TEST_F(ControllerSensorTest, TheThermometerSaysDegreesCelsius) {
  Sense(kThermo, 31500000);
  EXPECT_FLOAT_EQ(thermometer_get_value(robot_get_device(kThermo)), 31.5f);
  EXPECT_EQ(thermometer_get_value(robot_get_device(kPsd)), 0.0f);
  EXPECT_EQ(thermometer_get_value(0), 0.0f);
}

TEST_F(ControllerSensorTest, EnablingAndDisablingHaveNoEffect) {
  const DeviceTag thermo = robot_get_device(kThermo);
  Sense(kThermo, 20000000);
  thermometer_enable(thermo, 32);
  thermometer_disable(thermo);
  accelerometer_enable(robot_get_device(kUp), 32);
  accelerometer_disable(robot_get_device(kUp));
  EXPECT_FLOAT_EQ(thermometer_get_value(thermo), 20.0f);
}

TEST_F(ControllerSensorTest, TheConsoleGetsWhatIsPrinted) {
  robot_console_printf("%s %d\n", "wall at", 123);
  EXPECT_EQ(printed, "wall at 123\n");
  robot_console_printf("%500d", 1);
  EXPECT_EQ(printed.size(), 12u + 239u);
}

}  // namespace
}  // namespace openr_host
