// Tests of how robots are switched off.
#include "runtime/core/robot_table.h"

#include <gtest/gtest.h>

#include <memory>
#include <optional>

#include "runtime/core/robot_services.h"
#include "runtime/core/system.h"

namespace openr_host {
namespace {

// A robot with a boot timer of one second.
class TimerServices : public RobotServices {
 public:
  std::optional<int64_t> TimeOffUs() const override { return 1'000'000; }
};

class RobotTableTest : public testing::Test {
 protected:
  RobotTableTest() {
    for (int i = 0; i < 2; ++i) system.AddRobot("ERS-210", nullptr);
    system.robot(0).services = std::make_unique<TimerServices>();
    system.robot(0).load_again = [this] {
      ++boots_again;
      return true;
    };
    system.Boot();
    system.RunFor(1000);
  }

  System system;
  int boots_again = 0;
};

TEST_F(RobotTableTest, AShutdownWithABootTimerBootsTheRobotAgain) {
  system.Shutdown(0);
  system.RunFor(2'000'000);
  EXPECT_EQ(boots_again, 1);
}

TEST_F(RobotTableTest, ARobotThatIsSwitchedOffDuringItsShutdownDoesNotBootAgain) {
  system.Shutdown(0);
  system.PowerOff(0, {EndKind::kFatal, "an object called OPENR::Fatal()"});
  system.RunFor(2'000'000);
  EXPECT_EQ(boots_again, 0);
  ASSERT_TRUE(system.robot(0).end.has_value());
  EXPECT_EQ(system.robot(0).end->kind, EndKind::kFatal);
  EXPECT_FALSE(system.powered_off());
}

TEST(StrictRobotTest, AnErrorOfAnotherRobotDoesNotKeepARobotFromBootingAgain) {
  for (const int robot_with_error : {0, 1}) {
    System system({.strict = true});
    for (int i = 0; i < 2; ++i) system.AddRobot("ERS-210", nullptr);
    system.robot(0).services = std::make_unique<TimerServices>();
    system.robot(0).load_again = [&] {
      system.AddFindingAboutRobot(robot_with_error, Severity::kError, "an error during the boot");
      return true;
    };
    system.Boot();
    system.RunFor(1000);
    system.Shutdown(0);
    system.RunFor(2'000'000);
    EXPECT_EQ(system.robot(0).boots, 2);
    EXPECT_EQ(system.robot(0).powered_off, robot_with_error == 0);
  }
}

}  // namespace
}  // namespace openr_host
