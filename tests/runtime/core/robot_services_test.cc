// A robot without devices refuses every call, and its output parameters say that nothing was made.
#include "runtime/core/robot_services.h"

#include <gtest/gtest.h>

namespace openr_host {
namespace {

TEST(RobotWithoutDevicesTest, HasNoPrimitives) {
  RobotServices robot;
  OPrimitiveID id = 7;
  EXPECT_EQ(robot.OpenPrimitive("PRM:/a", &id), oNOT_FOUND);
  EXPECT_EQ(id, oprimitiveID_UNDEF);
  EXPECT_EQ(robot.ClosePrimitive(7), oINVALID_PRIMITIVE_ID);
  EXPECT_EQ(robot.ControlPrimitive(7, 3, nullptr, 0, nullptr, 0), oINVALID_PRIMITIVE_ID);
  OJointValue joint;
  EXPECT_EQ(robot.GetJointValue(7, &joint), oINVALID_PRIMITIVE_ID);
  OSensorValue sensor;
  EXPECT_EQ(robot.GetSensorValue(7, &sensor), oINVALID_PRIMITIVE_ID);
}

TEST(RobotWithoutDevicesTest, HasNoGains) {
  RobotServices robot;
  word gains[6] = {1, 2, 3, 4, 5, 6};
  EXPECT_EQ(robot.EnableJointGain(7), oINVALID_PRIMITIVE_ID);
  EXPECT_EQ(robot.DisableJointGain(7), oINVALID_PRIMITIVE_ID);
  EXPECT_EQ(robot.SetJointGain(7, gains), oINVALID_PRIMITIVE_ID);
  EXPECT_EQ(robot.GetJointGain(7, gains), oINVALID_PRIMITIVE_ID);
  EXPECT_EQ(robot.RegisterDefaultJointGain(7, gains), oINVALID_PRIMITIVE_ID);
  EXPECT_EQ(robot.SetDefaultJointGain(7), oINVALID_PRIMITIVE_ID);
  EXPECT_EQ(robot.GetDefaultJointGain(7, gains), oFAIL);
  EXPECT_EQ(gains[0], 1);
  EXPECT_EQ(gains[5], 6);
}

TEST(RobotWithoutDevicesTest, HasNoSyncKeys) {
  RobotServices robot;
  OVRSyncKey key = 7, key1 = 7, key2 = 7;
  EXPECT_EQ(robot.NewSyncKey(&key), oNO_SYNC_KEY);
  EXPECT_EQ(key, ovrsynckeyUNDEF);
  EXPECT_EQ(robot.CancelSyncKey(7), oINVALID_SYNC_KEY);
  EXPECT_EQ(robot.DivideSyncKey(7, &key1, &key2), oFAIL);
  EXPECT_EQ(key1, ovrsynckeyUNDEF);
  EXPECT_EQ(key2, ovrsynckeyUNDEF);
}

TEST(RobotWithoutDevicesTest, SupportsNoPowerClockOrVolume) {
  RobotServices robot;
  EXPECT_EQ(robot.SetCdtVectorData(7), oNOT_SUPPORTED);
  EXPECT_EQ(robot.SetMotorPower(opowerON), oNOT_SUPPORTED);
  OBootCondition boot;
  EXPECT_EQ(robot.GetBootCondition(&boot), oNOT_SUPPORTED);
  EXPECT_EQ(robot.Shutdown(boot), oNOT_SUPPORTED);
  OPowerStatus power;
  EXPECT_EQ(robot.GetPowerStatus(&power), oNOT_SUPPORTED);
  EXPECT_EQ(robot.ObservePowerStatus(power, OServiceEntry()), oNOT_SUPPORTED);
  EXPECT_EQ(robot.UnobservePowerStatus(OServiceEntry()), oNOT_SUPPORTED);
  OTime time;
  EXPECT_EQ(robot.SetTime(time), oNOT_SUPPORTED);
  EXPECT_EQ(robot.GetTime(&time), oNOT_SUPPORTED);
  sbyte hours = 0;
  EXPECT_EQ(robot.SetTimeDifference(1), oNOT_SUPPORTED);
  EXPECT_EQ(robot.GetTimeDifference(&hours), oNOT_SUPPORTED);
  OVolumeSwitch volume = 0;
  EXPECT_EQ(robot.SetVolumeSwitch(ovolumeSW1), oNOT_SUPPORTED);
  EXPECT_EQ(robot.GetVolumeSwitch(&volume), oNOT_SUPPORTED);
}

}  // namespace
}  // namespace openr_host
