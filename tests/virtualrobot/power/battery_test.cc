#include "virtualrobot/power/battery.h"

#include <gmock/gmock.h>

#include "tests/virtualrobot/comm_fixture.h"

namespace openr_host {
namespace {

constexpr int64_t kPercentUs = 54'000'000;  // 90 minutes / 100

Battery BatteryOf(const std::string& text) {
  Battery battery;
  EXPECT_EQ(ParseBattery(text, &battery), "") << text;
  return battery;
}

TEST(BatteryTest, StaysFullAtAHundredPercent) {
  EXPECT_EQ(BatteryOf("100%").PercentAt(0), 100);
  EXPECT_EQ(BatteryOf("100%").PercentAt(1000 * kPercentUs), 100);
}

TEST(BatteryTest, DrainsFromFullInNinetyMinutes) {
  const Battery battery = BatteryOf("drain");
  EXPECT_EQ(battery.PercentAt(0), 100);
  EXPECT_EQ(battery.PercentAt(kPercentUs - 1), 100);
  EXPECT_EQ(battery.PercentAt(kPercentUs), 99);
  EXPECT_EQ(battery.PercentAt(100 * kPercentUs), 0);
  EXPECT_EQ(battery.PercentAt(1000 * kPercentUs), 0);
}

TEST(BatteryTest, BeginsWhereItIsToldAndDrainsAsFast) {
  const Battery battery = BatteryOf("37%");
  EXPECT_EQ(battery.PercentAt(0), 37);
  EXPECT_EQ(battery.PercentAt(kPercentUs), 36);
  EXPECT_EQ(battery.PercentAt(37 * kPercentUs), 0);
  EXPECT_EQ(battery.PercentAt(1000 * kPercentUs), 0);
}

TEST(BatteryTest, OtherWordsAreRefusedWithThoseThereAre) {
  for (const char* wrong : {"", "0%", "101%", "101", "%", "-1%", "5.5%", "50%x", "full"}) {
    Battery battery;
    EXPECT_EQ(ParseBattery(wrong, &battery),
              std::string("'") + wrong +
                  "' is none of 100% (stays full), drain (full at boot) and 1% to 99% (so much at "
                  "boot, and drains)");
    EXPECT_TRUE(battery.drains);
  }
}

TEST(BatteryTest, ANumberWithoutItsPercentSignIsRefusedWithASuggestion) {
  Battery battery;
  EXPECT_THAT(ParseBattery("50", &battery), ::testing::EndsWith("; did you mean '50%'?"));
}

TEST(BatteryTest, IsLowAtBootBelowTenPercent) {
  EXPECT_TRUE(BatteryOf("9%").is_low_at_boot());
  EXPECT_FALSE(BatteryOf("10%").is_low_at_boot());
  EXPECT_FALSE(BatteryOf("drain").is_low_at_boot());
}

class LowBatteryTest : public VirtualRobotCommTest {
 protected:
  LowBatteryTest() : VirtualRobotCommTest(TenPercent()) {}
  static VirtualRobotOptions TenPercent() {
    VirtualRobotOptions options;
    options.battery = {10, true};
    return options;
  }
  void ShutDown() {
    As([] { OPENR::Shutdown(OBootCondition(obcbPAUSE_SW)); });
    system.RunFor(kFrameUs);
    ASSERT_TRUE(system.end());
  }
};

TEST_F(LowBatteryTest, AShutdownWithALowBatteryIsItsEnd) {
  Boot();
  RunToFrame(kPercentUs / kFrameUs);
  As([] {
    OPowerStatus status;
    EXPECT_EQ(OPENR::GetPowerStatus(&status), oSUCCESS);
    EXPECT_EQ(status.remainingCapacity, 9);
    EXPECT_NE(status.robotStatus & orsbBATTERY_CAPACITY_LOW, 0u);
  });
  ShutDown();
  EXPECT_EQ(system.end()->kind, EndKind::kBattery);
  EXPECT_EQ(system.end()->why,
            "mover shut the robot down with 9 % left in its battery; --battery 100% keeps it full");
}

TEST_F(LowBatteryTest, AShutdownBeforeThatIsTheObjectsOwn) {
  Boot();
  RunToFrame(100);
  ShutDown();
  EXPECT_EQ(system.end()->kind, EndKind::kPowerOff);
}

TEST_F(LowBatteryTest, AStopAtOnceCountsMoreThanAShutdownThatIsUnderWay) {
  Boot();
  As([] { OPENR::Shutdown(OBootCondition(obcbPAUSE_SW)); });
  EXPECT_FALSE(system.end());
  system.PowerOff(dog, {EndKind::kLostProcess, "it is gone"});
  ASSERT_TRUE(system.end());
  EXPECT_EQ(system.end()->kind, EndKind::kLostProcess);
  system.PowerOff(dog, {EndKind::kFatal, "too late"});
  EXPECT_EQ(system.robot(dog).end->kind, EndKind::kLostProcess);
}

TEST_F(LowBatteryTest, ThePauseButtonComesFirst) {
  Boot();
  RunToFrame(kPercentUs / kFrameUs);
  robot->PressPause();
  ShutDown();
  EXPECT_EQ(system.end()->kind, EndKind::kPause);
}

}  // namespace
}  // namespace openr_host
