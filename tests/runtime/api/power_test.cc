#include <OPENR/OPower.h>
#include <gtest/gtest.h>

#include "runtime/api/power_text.h"

namespace {

// Returns the status of a battery that discharges at 25.1 C.
OPowerStatus Sample() {
  return OPowerStatus(orsbMOTOR_POWER | orsbBATTERY_CONNECTED,
                      obsbDISCHARGING | obsbINITIALIZED | obsecBUSY, 84, 2983, 1800, 7400, -320, 9,
                      2);
}

TEST(OPowerStatusTest, TheDefaultIsAllZero) {
  const OPowerStatus status;
  EXPECT_EQ(status.robotStatus, 0u);
  EXPECT_EQ(status.batteryStatus, 0);
  EXPECT_EQ(status.current, 0);
  EXPECT_EQ(status.timeDif, 0);
  EXPECT_EQ(status.volume, 0);
}

TEST(OPowerStatusTest, SetWritesTheSixFieldsThatCanBeObserved) {
  OPowerStatus status = Sample();
  status.Set(orsbPAUSE, obsbFULLY_CHARGED, 1, 2, 3, 4);
  EXPECT_EQ(status.robotStatus, orsbPAUSE);
  EXPECT_EQ(status.batteryStatus, obsbFULLY_CHARGED);
  EXPECT_EQ(status.remainingCapacity, 1);
  EXPECT_EQ(status.temperature, 2);
  EXPECT_EQ(status.timeDif, 3);
  EXPECT_EQ(status.volume, 4);
  EXPECT_EQ(status.fullyChargedCapacity, 1800);
  EXPECT_EQ(status.voltage, 7400);
  EXPECT_EQ(status.current, -320);
}

TEST(OPowerStatusTest, AllNamesEveryBit) {
  EXPECT_EQ(orsbALL, (orsbSPECIAL_DATA_READ_REQ << 1) - 1);
  EXPECT_EQ(openr_host::PowerDetails(OPowerStatus(orsbALL, 0, 0, 0, 0, 0, 0, 0, 0)).size(),
            29u + 8u);
}

TEST(OPowerStatusTest, TheSummaryHasUnits) {
  EXPECT_EQ(openr_host::PowerSummary(Sample()),
            "robot 0x00000042, battery 0x00c1, 84 %, 25.1 C, 1800 mAh, 7400 mV, -320 mA, UTC+9, "
            "volume 2");
}

TEST(OPowerStatusTest, TheDetailsNameTheBitsThatAreSet) {
  const std::vector<std::string> expected = {
      "orsbMOTOR_POWER",       "orsbBATTERY_CONNECTED",
      "obsbDISCHARGING",       "obsbINITIALIZED",
      "battery error code 1",  "remaining capacity 84 %",
      "temperature 25.1 C",    "fully charged capacity 1800 mAh",
      "voltage 7400 mV",       "current -320 mA",
      "time difference UTC+9", "volume 2"};
  EXPECT_EQ(openr_host::PowerDetails(Sample()), expected);
}

TEST(OBootConditionTest, ArgumentsThatAreLeftOutAreZero) {
  const OBootCondition none;
  EXPECT_EQ(none.bitmap, 0);
  const OBootCondition button(obcbPAUSE_SW);
  EXPECT_EQ(button.bitmap, obcbPAUSE_SW);
  EXPECT_EQ(button.bootTime, 0);
  EXPECT_EQ(button.bootTimeType, obcbttRELATIVE);
  EXPECT_EQ(button.vibrationLevel, 0);
}

TEST(OBootConditionTest, TheFullFormKeepsAllFour) {
  const OBootCondition all(obcbBOOT_TIMER | obcbVIBRATION_DETECTED, 60, obcbttABSOLUTE, 3);
  EXPECT_EQ(all.bitmap, obcbBOOT_TIMER | obcbVIBRATION_DETECTED);
  EXPECT_EQ(all.bootTime, 60);
  EXPECT_EQ(all.bootTimeType, obcbttABSOLUTE);
  EXPECT_EQ(all.vibrationLevel, 3);
}

}  // namespace
